#include "source/app/files/PartialPicture.h"

#include <exception>

#include "R2/ImageFile.h"
#include "source/app/files/OutputFile.h"
#include "source/app/report/Info.h"

namespace ray {

std::string PartialName(const std::string& picture) { return NameBeside(picture, "partial"); }

bool IsFinishedPicture(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return false;
  try {
    const R2::ImageSettings settings = R2::ReadImageHeader(ReadBytes(file.string())).settings;
    const auto pixels = settings.find("pixels");
    return pixels == settings.end() || pixels->second == "complete";
  } catch (const std::exception&) {
    return true;  // it is no picture, or cannot be read: somebody else's
  }
}

}  // namespace ray

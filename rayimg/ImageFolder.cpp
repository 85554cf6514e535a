#include "rayimg/ImageFolder.h"

#include <algorithm>
#include <filesystem>

#include "R2/ImageFile.h"
#include "source/app/Status.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {

std::vector<std::string> ImagesIn(const std::string& folder) {
  std::vector<std::string> images, extensions;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    const std::string name = at->path().string();
    if (R2::FormatForName(name) && !at->is_directory(ignored)) images.push_back(name);
  }
  if (error) throw SceneErrors({ErrorIn(folder, error.message())});
  for (const R2::ImageFormat& format : R2::ImageFormats())
    for (const char* extension : format.extensions) extensions.push_back("." + std::string(extension));
  if (images.empty())
    throw UsageError("the folder " + QuotedPath(folder) + " contains no image: no file ends in " + OneOf(extensions));
  std::ranges::sort(images);
  return images;
}

}  // namespace ray::rayimg

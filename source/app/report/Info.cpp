#include "source/app/report/Info.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "R2/ImageFile.h"
#include "source/app/report/Memory.h"
#include "source/app/report/Resources.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {
namespace {

[[noreturn]] void Refuse(const std::string& file, const std::string& reason) {
  throw SceneErrors({ErrorIn(file, reason)});
}

}  // namespace

std::vector<unsigned char> ReadBytes(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) Refuse(file, "no such file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) Refuse(file, "the file cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

R2::DecodedImage DecodePicture(const std::string& file, std::span<const unsigned char> bytes) {
  try {
    const R2::ImageSize size = R2::ReadImageSize(bytes);
    const std::int64_t needed = std::int64_t{3 * sizeof(float)} * size.width * size.height, limit = MemoryLimit({});
    if (needed > limit - PeakMemory())
      Refuse(file, "decoding it takes " + std::to_string(needed >> 20) + " MiB, and this machine allows " +
                       std::to_string(limit >> 20) + " MiB in all");
    return R2::DecodeImage(bytes);
  } catch (const R2::ImageError& error) {
    Refuse(file, error.what());
  }
}

R2::DecodedImage ReadPicture(const std::string& file) { return DecodePicture(file, ReadBytes(file)); }

std::string PictureText(const std::string& file, const R2::ImageHeader& picture) {
  std::string text = Escaped(file) + ": " + picture.format->name + ", " + std::to_string(picture.size.width) + "x" +
                     std::to_string(picture.size.height) + "\n";
  for (const auto& [key, value] : picture.settings) text += Escaped(key) + ": " + Escaped(value) + "\n";
  return text;
}

std::string PictureInfo(const std::string& file) {
  try {
    return PictureText(file, R2::ReadImageHeader(ReadBytes(file)));
  } catch (const R2::ImageError& error) {
    Refuse(file, error.what());
  }
}

}  // namespace ray

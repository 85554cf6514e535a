#include "source/app/report/Info.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "R2/ImageFile.h"
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
    return R2::DecodeImage(bytes);
  } catch (const R2::ImageError& error) {
    Refuse(file, error.what());
  }
}

R2::DecodedImage ReadPicture(const std::string& file) { return DecodePicture(file, ReadBytes(file)); }

std::string PictureText(const std::string& file, const R2::DecodedImage& picture) {
  std::string text = Escaped(file) + ": " + picture.format->name + ", " + std::to_string(picture.image.Width()) + "x" +
                     std::to_string(picture.image.Height()) + "\n";
  for (const auto& [key, value] : picture.settings) text += Escaped(key) + ": " + Escaped(value) + "\n";
  return text;
}

std::string PictureInfo(const std::string& file) { return PictureText(file, ReadPicture(file)); }

}  // namespace ray

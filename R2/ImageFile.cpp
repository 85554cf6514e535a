#include "R2/ImageFile.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>

#include "R1/Kinds.h"

namespace R2 {
namespace {

/// Converts ASCII letters only, so that the locale does not affect file formats.
char LowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

const ImageFormat& FormatOfContent(std::span<const unsigned char> bytes) {
  std::string known;
  for (const ImageFormat& format : ImageFormats()) {
    if (format.recognizes(bytes)) return format;
    known += known.empty() ? "" : ", ";
    known += format.name;
  }
  if (bytes.empty()) throw ImageError("the image file is empty");
  throw ImageError("unknown image format; supported: " + known);
}

}  // namespace

std::span<const ImageFormat> ImageFormats() {
#define IMAGE_FORMAT(name) *KIND(ImageFormat, name##_format),
  static const std::array formats{
#include "R2/image_formats.def"
  };
  return formats;
}

const ImageFormat* FormatForName(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  if (extension.empty()) return nullptr;
  extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(), LowerCase);
  for (const ImageFormat& format : ImageFormats())
    for (const char* own : format.extensions)
      if (extension == own) return &format;
  return nullptr;
}

DecodedImage DecodeImage(std::span<const unsigned char> bytes) {
  const ImageFormat& format = FormatOfContent(bytes);
  try {
    DecodedImage decoded = format.decode(bytes);
    decoded.format = &format;
    return decoded;
  } catch (const std::bad_alloc&) {
    throw ImageError("not enough memory for the image");
  }
}

ImageSize ReadImageSize(std::span<const unsigned char> bytes) { return FormatOfContent(bytes).read_size(bytes); }

ImageHeader ReadImageHeader(std::span<const unsigned char> bytes) {
  const ImageFormat& format = FormatOfContent(bytes);
  return {format.read_size(bytes), &format, format.read_settings ? format.read_settings(bytes) : ImageSettings{}};
}

}  // namespace R2

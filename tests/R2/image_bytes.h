#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "R2/ImageFile.h"
#include "tests/Folder.h"

/// Image files as bytes, for the tests of every format.
namespace R2 {

using Bytes = std::vector<unsigned char>;

inline Bytes ToBytes(std::string_view text) { return {text.begin(), text.end()}; }

inline Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline const ImageFormat& Format(const std::string& name) {
  for (const ImageFormat& format : ImageFormats())
    if (format.name == name) return format;
  throw std::runtime_error("no format " + name);
}

/// Returns the error message of DecodeImage; empty if there is none.
inline std::string Complaint(const Bytes& bytes) {
  return project::MessageOf<ImageError>([&] { DecodeImage(bytes); });
}

/// Makes an image that is smooth, so that JPEG stays close; brighter upwards, redder to the right.
inline Image Gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.Set(x, y, {(x + 0.5) / width, (y + 0.5) / height, 0.25 + 0.5 * (y + 0.5) / height});
  return image;
}

}  // namespace R2

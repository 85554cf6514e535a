#pragma once

#include <functional>
#include <string>

#include "R2/ImageFile.h"

namespace ray {

/// The name that stands for standard input as a scene, and for standard output as an image.
inline constexpr const char* standard_stream = "-";

/// The format of an image by its extension; PNG for standard output. Null if there is none.
inline const R2::ImageFormat* FormatOfPicture(const std::string& name) {
  return R2::FormatForName(name == standard_stream ? "-.png" : name);
}

/// Encodes images as the file of that name will hold them, and throws the bytes away: to measure how long that takes.
inline std::function<void(const R2::Image&)> EncoderOf(const std::string& name, const R2::ImageEncoding& encoding) {
  return [name, encoding](const R2::Image& image) { FormatOfPicture(name)->encode(image, encoding, {}); };
}

}  // namespace ray

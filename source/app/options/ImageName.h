#pragma once

#include <functional>
#include <string>

#include "R2/ImageFile.h"

namespace ray {

/// The name of standard input as a scene, and of standard output as an image.
inline constexpr const char* standard_stream = "-";

/// Returns the format for the extension of an image; PNG for standard output. Null if there is none.
inline const R2::ImageFormat* FormatOfImage(const std::string& name) {
  return R2::FormatForName(name == standard_stream ? "-.png" : name);
}

/// Returns a function that encodes images in the format of that file and discards the bytes, to measure the time.
inline std::function<void(const R2::Image&)> EncoderOf(const std::string& name, const R2::ImageEncoding& encoding) {
  return [name, encoding](const R2::Image& image) { FormatOfImage(name)->encode(image, encoding, {}); };
}

}  // namespace ray

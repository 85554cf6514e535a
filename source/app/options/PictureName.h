#pragma once

#include <string>

#include "R2/ImageFile.h"

namespace ray {

/// The name that stands for standard input as a scene, and for standard output as an image.
inline constexpr const char* standard_stream = "-";

/// The format of an image by its extension; PNG for standard output. Null if there is none.
inline const R2::ImageFormat* FormatOfPicture(const std::string& name) {
  return R2::FormatForName(name == standard_stream ? "-.png" : name);
}

}  // namespace ray

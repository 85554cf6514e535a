#pragma once

#include <string>

#include "R2/ImageFile.h"

namespace ray {

/// As the name of a scene standard input, as that of a picture standard output.
inline constexpr const char* standard_stream = "-";

/// By its extension; PNG for standard output. Null when there is none.
inline const R2::ImageFormat* FormatOfPicture(const std::string& name) {
  return R2::FormatForName(name == standard_stream ? "-.png" : name);
}

}  // namespace ray

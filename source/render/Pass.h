#pragma once

#include <cstdint>
#include <optional>

#include "source/film/PictureError.h"

namespace ray {

/// What one doubling of the samples gave.
struct Pass {
  std::uint32_t end = 0;  // samples a pixel and stream, of blocks that went on
  double samples = 0;     // a pixel, on average
  double seconds = 0;     // since the render began
  std::optional<ErrorEstimate> error;
};

}  // namespace ray

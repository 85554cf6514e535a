#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/render/PixelTrace.h"

namespace ray {

/// What a pixel shows, as the tracer found it with the pixel's first sample.
struct Pick {
  PixelTrace trace;
  std::optional<R3::Point> point;  // nothing where the background is seen
  std::uint32_t instance = 0;
  std::vector<std::string> text;  // node path, place, surface, material, rays; lines for people
};

Pick PickPixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column, int row);

}  // namespace ray

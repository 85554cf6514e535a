#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/render/PixelTrace.h"

namespace ray {

/// The content of a pixel, as its first sample found it.
struct Pick {
  PixelTrace trace;
  std::optional<R3::Point> point;  // std::nullopt for the background
  std::uint32_t instance = 0;
  std::vector<std::string> text;  // node path, position, surface, material and rays, a line each
};

Pick PickPixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column, int row);

}  // namespace ray

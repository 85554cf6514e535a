#pragma once

#include <string>

#include "source/render/PixelTrace.h"

namespace ray {

/// Returns the rays of a pixel as lines in its image: JSON, an array with an entry [kind, depth, x0, y0, x1, y1, look,
/// ...] per ray, in the order in which RayTree writes them and at most as many.
///   kind    a RayKind as a number
///   depth   bounces before the ray
///   x, y    ends of a line, in pixels from the lower left corner of the whole image
///   look    0 where the line is visible, 1 where something hides it; 2 more beyond what blocks a shadow ray
std::string RaysInImage(const PixelTrace& trace, const World& world, const Accelerator& accelerator,
                        const RenderSettings& settings);

}  // namespace ray

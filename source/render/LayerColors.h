#pragma once

#include <string>

#include "R2/Image.h"

namespace ray {

/// A layer as a screen of 0..1 can show it: depth from white, the nearest, to black; normals as (N + 1) / 2; a colour
/// of its own for each id. Others as they are.
R2::Image LayerAsShown(const std::string& layer, const R2::Image& image);

}  // namespace ray

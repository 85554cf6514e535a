#pragma once

#include "R2/Image.h"
#include "source/integrate/Integrators.h"

namespace ray {

/// An image of that mode as a screen of 0..1 can show it: depth from white, the nearest, to black; normals as (N + 1) /
/// 2; a different color for each id. Images of other modes stay as they are.
R2::Image LayerAsShown(RenderMode mode, const R2::Image& image);
/// Whether that changes nothing, so that large pictures need not be copied.
bool IsShownAsItIs(RenderMode mode);

}  // namespace ray

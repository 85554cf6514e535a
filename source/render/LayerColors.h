#pragma once

#include "R2/Image.h"
#include "source/integrate/Integrators.h"

namespace ray {

/// A picture in that mode as a screen of 0..1 can show it: depth from white, the nearest, to black; normals as (N + 1)
/// / 2; a color of its own for each id. Others as they are.
R2::Image LayerAsShown(RenderMode mode, const R2::Image& image);
/// Whether that changes nothing, so that large pictures need not be copied.
bool IsShownAsItIs(RenderMode mode);

}  // namespace ray

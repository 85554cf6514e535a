#pragma once

#include "R2/Image.h"
#include "source/integrate/Integrators.h"

namespace ray {

/// Returns an image of that mode converted to the range 0..1 of a screen: depth from white, the nearest, to black;
/// normals as (N + 1) / 2; a different color for each id. Images of other modes are unchanged.
R2::Image LayerAsShown(RenderMode mode, const R2::Image& image);
/// Returns true if the conversion changes nothing, so that large images need not be copied.
bool IsShownAsItIs(RenderMode mode);

}  // namespace ray

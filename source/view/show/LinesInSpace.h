#pragma once

#include "source/view/ViewerState.h"

namespace ray {

/// Boxes, lights, cameras and rays.
Lines MakeLines(const ViewerState& viewer);
/// What keeps its size on the screen: the pivot, the pick, and what is moved.
Lines MakeMarks(const ViewerState& viewer);
/// Around the crop, which there must be, as deep in the view as the middle of what is drawn.
Lines FrameOfCrop(const ViewerState& viewer);
/// Whether a frame is drawn around the rendered image in space.
bool ShowsFrameOfQuad(const ViewerState& viewer);
/// Around all that is drawn in space.
R3::Box BoxOfDrawing(const ViewerState& viewer);

}  // namespace ray

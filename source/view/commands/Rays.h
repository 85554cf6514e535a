#pragma once

#include <optional>

#include "source/view/ViewerState.h"

/// The rays that are traced to be looked at.
namespace ray {

/// Shows or hides the rays of every 25th pixel, of the rendered image if there is one.
void ToggleGrid(ViewerState& viewer);
/// Shows the rays of the pixel at a position of the drawing: of the rendered image if that is seen there, else of the
/// view.
void DebugPixelAt(ViewerState& viewer, const R2::Point& position);
/// Goes to the pixel next to it, or moves the cross section, whichever was used last.
void MoveByArrow(ViewerState& viewer, int right, int up);
void ForgetPixel(ViewerState& viewer);
void SaveRays(ViewerState& viewer);
/// Shows more or fewer bounces.
void StepBounce(ViewerState& viewer, int by);
/// One of the pixel's rays, by its number, to be lit up; nothing for none.
void ChooseRay(ViewerState& viewer, std::optional<std::size_t> ray);
void ToggleRays(ViewerState& viewer, ShownRays kind);
void ToggleNormals(ViewerState& viewer);
/// How many rays are traced to be looked at from now on.
void SetDebugRays(ViewerState& viewer, const DebugRayCounts& counts);

}  // namespace ray

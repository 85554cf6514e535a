#pragma once

#include "source/view/ViewerState.h"

/// The rendered image shown flat.
namespace ray {

void ToggleFlat(ViewerState& viewer);
/// Moves the image, or its slider.
void DragFlat(ViewerState& viewer, const R2::Point& from, const R2::Point& to, bool moves_slider);
bool TakesSlider(const ViewerState& viewer, const ButtonEvent& event);
void ZoomFlat(ViewerState& viewer, const ScrollEvent& event);

}  // namespace ray

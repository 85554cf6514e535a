#pragma once

#include <string>

#include "source/view/ViewerState.h"

/// The cross section beside the view.
namespace ray {

void ToggleSection(ViewerState& viewer);
/// Shows the cut along that plane, whatever was shown before.
void ShowSection(ViewerState& viewer, SlicePlane plane);
void NextPlane(ViewerState& viewer);
void MoveSection(ViewerState& viewer, int by);
/// How wide all lines are, in pixels: wider on denser screens.
int LineWidth(const ViewerState& viewer);
/// Makes its drawing again where that is due; it is shown.
void MakeSection(ViewerState& viewer);
/// What is under the pointer; empty where that is not on the cross section.
std::string TextOfSection(const ViewerState& viewer);

}  // namespace ray

#pragma once

#include <optional>
#include <string>

#include "source/view/ViewerState.h"

/// The view: where it is looked from, and kept.
namespace ray {

/// Prints the camera as a line of a scene, and copies it to the clipboard.
void PrintCamera(ViewerState& viewer);
/// Around the scene, and its lights when they are shown.
R3::Box BoxToFrame(const ViewerState& viewer);
void FrameScene(ViewerState& viewer);
void FramePicked(ViewerState& viewer);
void FrameChosenNode(ViewerState& viewer);
void Widen(ViewerState& viewer, double factor);
/// `name`: of the direction.
void LookAlong(ViewerState& viewer, const R3::Vector& towards, const R3::Vector& up, const std::string& name);
void ToggleTurntable(ViewerState& viewer);
void GoBack(ViewerState& viewer);
void GoForward(ViewerState& viewer);
void GoToSceneCamera(ViewerState& viewer);
/// The center of the scene for nothing.
void SetPivot(ViewerState& viewer, const std::optional<R3::Point>& pivot);
void KeepBookmark(ViewerState& viewer, int digit);
void RecallBookmark(ViewerState& viewer, int digit);

}  // namespace ray

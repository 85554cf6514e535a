#pragma once

#include <optional>

#include "source/view/ViewerState.h"

/// Rendering of the view: by key S row by row, and live.
namespace ray {

/// Renders the view row by row, or continues where that was stopped.
void StartTrace(ViewerState& viewer);
/// The next render takes this rectangle alone, between two positions in the drawing, of the view.
void Crop(ViewerState& viewer, const R2::Point& from, const R2::Point& to);
void ClearCrop(ViewerState& viewer);
/// `mode`: instead of the settings' own; nothing for that.
void ToggleLive(ViewerState& viewer, std::optional<RenderMode> mode);
/// Live rendering of one mode; nothing for none.
void ShowLayer(ViewerState& viewer, std::optional<RenderMode> mode);
void ToggleDenoising(ViewerState& viewer);
/// Saves and keeps what has ended since the last call; to be called now and then.
void TakeEndedJobs(ViewerState& viewer);
/// Begins to find what accelerators cost in the present view, in the background.
void CompareAccelerators(ViewerState& viewer);
void StopComparingAccelerators(ViewerState& viewer);

}  // namespace ray

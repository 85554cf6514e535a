#pragma once

#include <optional>

#include "source/view/ViewerState.h"

/// What is shown and chosen, and what is closed again.
namespace ray {

/// Ends the uppermost of what is open: the help, the flat image, the crop, the pick, the cross section, the rendering.
void Peel(ViewerState& viewer);
/// Unless that would lose something; then when it is asked for again.
void Quit(ViewerState& viewer);
/// `what`: its name in the message.
void Toggle(ViewerState& viewer, const char* what, bool SpaceOverlays::*shows);
void ToggleLights(ViewerState& viewer);
/// Bounding boxes: none, of the scene graph, of the accelerator.
void CycleBoxes(ViewerState& viewer);
void ShowBoxes(ViewerState& viewer, SpaceOverlays::Boxes boxes);
void ChangeBoxLevel(ViewerState& viewer, int by);
void ToggleHelp(ViewerState& viewer);
void TogglePanels(ViewerState& viewer);
void ShowPanels(ViewerState& viewer, const PanelSettings& look);
void SetPanelLook(ViewerState& viewer, const PanelSettings& look);
/// A node of the scene graph to look at, into World::Nodes; nothing for none.
void ChooseNode(ViewerState& viewer, std::optional<std::size_t> node);
/// Describes and chooses what is seen at a position of the picture.
void PickAt(ViewerState& viewer, const R2::Point& position);
void FocusUnderPointer(ViewerState& viewer);

}  // namespace ray

#pragma once

#include "source/view/panels/Panel.h"

namespace ray {

/// The scene, what its preview lacks for speed, how far its image has come and how right it is, and the pixel under the
/// pointer: in the window of Dear ImGui that is being made, a line of its width.
void DrawStatusBar(PanelFrame& frame);

}  // namespace ray

#pragma once

#include <memory>

#include "source/view/panels/Panels.h"

/// Letters and colors of panels, of the Dear ImGui context that is current.
namespace ray {

inline constexpr double letter_height = 13;  // units of length: the height of Dear ImGui's own letters

/// Colors and distances. `scale` as of Panels.
void UseLook(PanelTheme theme, double scale);

/// Letters of that scale: DejaVu Sans Mono where the system has it, else those of Dear ImGui.
std::shared_ptr<const InkSheet> UseLetters(double scale);

}  // namespace ray

#pragma once

#include <memory>
#include <span>

#include "source/draw/Drawing.h"
#include "source/view/panels/Panels.h"

namespace ray {

// Letters and colors of panels, of the Dear ImGui context that is current.

inline constexpr double letter_height = 13;  // units of length: the height of Dear ImGui's own letters

/// Colors and distances. `scale` as of Panels.
void UseLook(PanelTheme theme, double scale);

/// Letters of that scale: DejaVu Sans Mono where the system has it, else those of Dear ImGui.
std::shared_ptr<const InkSheet> UseLetters(double scale);

/// The size of letters of labels, which are written as panels are. No frame has to be open.
///   scale   pixels per unit of length
LetterSize LettersOfLabels(double scale);

/// Writes labels behind all panels, each at its position, over a background of the theme.
void DrawLabels(std::span<const Label> labels, double scale, PanelTheme theme);

}  // namespace ray

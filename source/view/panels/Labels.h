#pragma once

#include <span>

#include "source/draw/Drawing.h"
#include "source/view/panels/Panels.h"

namespace ray {

/// The size of letters of labels, which are written as panels are. No frame has to be open.
///   scale   pixels per unit of length
LetterSize LettersOfLabels(double scale);

/// Writes labels behind all panels, each over a ground of the theme, from where they say to where they end.
void DrawLabels(std::span<const Label> labels, double scale, PanelTheme theme);

}  // namespace ray

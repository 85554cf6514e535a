#pragma once

#include <string>

#include "source/view/ViewerState.h"

namespace ray {

/// "hello.scn 512x512 4 of 16 samples 31 % 0.5 Mrays/s 12 s left"
std::string TitleOf(const ViewerState& viewer);
/// What is shown, in lines of words, for scripts.
std::string StateInWords(ViewerState& viewer);
/// What the panels and the help say, in lines; none where they are hidden.
std::string TextOfPanels(ViewerState& viewer);

}  // namespace ray

#pragma once

#include <memory>

#include "source/draw/FrameState.h"
#include "source/view/ViewerState.h"

namespace ray {

/// What is to be drawn now. `lines`: those of MakeLines.
FrameState MakeFrame(ViewerState& viewer, std::shared_ptr<const Lines> lines);

}  // namespace ray

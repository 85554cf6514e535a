#pragma once

#include "source/view/overlay/SliceView.h"

/// A cut as lines in the square from -1 to 1.
namespace ray {

/// The pieces, each in the color of its instance's material, made bright enough for a dark background.
Lines CutLines(const SceneCut& cut, const World& world, const SliceView& view);

/// The insides of what is cut, in the same colors, fainter: a line through the middle of each row of pixels. Of solids,
/// and of others whose cut consists of closed curves. What has no end on a row is not filled there. Lines that are
/// several pixels wide lie over each other, and are the fainter.
Lines CutFilling(const SceneCut& cut, const World& world, const SliceView& view, int line_width = 1);

}  // namespace ray

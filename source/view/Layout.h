#pragma once

#include "source/draw/CameraMoves.h"
#include "source/draw/FlatView.h"

namespace ray {

/// The pieces of the drawing, from the left: the view of the scene; the cross section, where it is shown; and the
/// column of panels, where they are, as high as all of it. Their status bar is above the former two.
struct Layout {
  /// `column`: how wide panels are, and `bar` how high their status bar; 0 where they are hidden.
  static Layout Of(const DrawingSize& all, double column, double bar, bool has_section);

  /// Whether a position in the drawing is on the cross section.
  bool IsOnSection(const R2::Point& position) const;
  /// A position in the drawing as one on the cross section.
  R2::Point OnSection(const R2::Point& position) const { return {position.x - view.width, position.y}; }
  /// Where an image of that many pixels is in the view, as large as there is room, in the middle.
  PixelBox PlaceFor(double width, double height) const;

  DrawingSize view, section;  // the former at least 1 x 1, the latter of width 0 where it is hidden
};

}  // namespace ray

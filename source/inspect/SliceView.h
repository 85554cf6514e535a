#pragma once

#include <array>
#include <string>
#include <vector>

#include "source/draw/CameraMoves.h"
#include "source/inspect/CrossSection.h"

namespace ray {

/// The mapping of a slice to a drawing: the whole cut of the scene, as large as fits into `size` pixels.
struct SliceView {
  R2::Point middle;        // of the drawing, in the slice's coordinates
  double pixel = 1;        // the side of one, in the slice's units, > 0
  DrawingSize size{1, 1};  // of the drawing, at least 1 each

  static SliceView Of(const Slice& slice, const R3::Box& scene, const DrawingSize& size);

  /// Converts a point of the slice to pixels, from the lower left corner of the drawing, and back.
  R2::Point Pixel(const R2::Point& p) const {
    return {(p.x - middle.x) / pixel + size.width / 2.0, (p.y - middle.y) / pixel + size.height / 2.0};
  }
  R2::Point InSlice(const R2::Point& at) const {
    return {middle.x + (at.x - size.width / 2.0) * pixel, middle.y + (at.y - size.height / 2.0) * pixel};
  }
  /// Returns the point in the square from -1 to 1 that is the drawing, z = 0.
  std::array<float, 3> At(const R2::Point& p) const {
    return {static_cast<float>((p.x - middle.x) / (pixel * size.width / 2)),
            static_cast<float>((p.y - middle.y) / (pixel * size.height / 2)), 0};
  }
};

/// The axes of the numbers at a slice.
struct SliceCoordinates {
  std::array<std::string, 2> names;  // of the axes to the right and upward
  R2::Point origin;                  // where both are 0, in the slice's coordinates
  std::string origin_name;
};

/// Lines in the square from -1 to 1, and labels in pixels from its lower left corner.
struct SliceAxes {
  Lines lines;
  std::vector<Label> labels;
};

/// Numbers along the lower and the left edge with faint lines through them, and a scale: a bar labeled
/// with its length. `letters`: of labels.
SliceAxes AxesOf(const SliceView& view, const SliceCoordinates& coordinates, const LetterSize& letters);

/// Returns the least of 1, 2 and 5 times powers of ten that fits at most `most` (>= 1) times into `range` (> 0).
double TickStep(double range, int most);

// A cut as lines in the square from -1 to 1.

/// The pieces, each in the color of its instance's material, made bright enough for a dark background.
Lines CutLines(const SceneCut& cut, const World& world, const SliceView& view);

/// The fill of cut objects, in the same colors, fainter: a line through the middle of each row of pixels. Solids are
/// filled, and other objects whose cut consists of closed curves, except in rows where a curve is open. Lines wider
/// than a pixel overlap, and are fainter.
Lines CutFilling(const SceneCut& cut, const World& world, const SliceView& view, int line_width = 1);

}  // namespace ray

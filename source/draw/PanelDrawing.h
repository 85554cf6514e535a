#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "source/draw/Drawing.h"

namespace ray {

/// The coverage of each pixel by ink, 0 to 255, in rows from the top: the letters of panels, and a fully covered area
/// for filled shapes.
struct InkSheet {
  int width = 0, height = 0;
  std::vector<std::uint8_t> ink;
};

/// Panels as triangles, for a painter. Positions are in pixels from the upper left corner of the drawing.
struct PanelDrawing {
  struct Corner {
    float x = 0, y = 0;
    float u = 0, v = 0;  // on the sheet, from 0 at its upper left corner to 1
    Rgba color{};
    friend auto operator<=>(const Corner&, const Corner&) = default;
  };
  /// Some of the triangles, and the rectangle to which they are clipped.
  struct Part {
    int left = 0, top = 0, right = 0, bottom = 0;
    std::size_t first = 0, count = 0;  // of `indices`
  };

  std::vector<Corner> corners;
  std::vector<std::uint32_t> indices;  // three per triangle
  std::vector<Part> parts;             // in the order of drawing
  std::shared_ptr<const InkSheet> sheet;
};

}  // namespace ray

#pragma once

#include <functional>
#include <vector>

#include "source/scene/Camera.h"

namespace ray {

/// A piece of a line in space as an image shows it, in pixels from its lower left corner; visible or hidden as a whole.
struct ImageLine {
  R2::Point from, to;
  bool is_hidden = false;
};

/// Draws lines in space over an image of any projection.
class ImageLines {
 public:
  /// Returns true if nothing hides `p`, which is seen along `sight`, at `place` in the image.
  using IsVisible = std::function<bool(const R3::Point& p, const R3::Ray& sight, const R2::Point& place)>;

  ImageLines(const Camera& camera, int columns, int rows, IsVisible is_visible)
      : camera_(camera), width_(columns), height_(rows), is_visible_(std::move(is_visible)) {}

  /// Returns the pieces of a segment, each about 8 pixels long, at most 32; without parts that the image does not see,
  /// and those behind a pinhole.
  std::vector<ImageLine> Of(const R3::Point& from, const R3::Point& to) const;

 private:
  bool IsTorn(const R2::Point& from, const R2::Point& to, const R3::Point& middle) const;

  const Camera camera_;
  const int width_, height_;
  const IsVisible is_visible_;
};

}  // namespace ray

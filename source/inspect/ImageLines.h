#pragma once

#include <functional>
#include <vector>

#include "source/scene/Camera.h"

namespace ray {

/// A segment of the projection of a line in space, in pixels from the lower left corner; completely visible or hidden.
struct ImageLine {
  R2::Point from, to;
  bool is_hidden = false;
};

/// Draws lines in space over an image of any projection.
class ImageLines {
 public:
  /// Returns true if `p`, in direction `sight` and at `place` in the image, is not hidden.
  using IsVisible = std::function<bool(const R3::Point& p, const R3::Ray& sight, const R2::Point& place)>;

  ImageLines(const Camera& camera, int columns, int rows, IsVisible is_visible)
      : camera_(camera), width_(columns), height_(rows), is_visible_(std::move(is_visible)) {}

  /// Returns the pieces of a segment, each about 8 pixels long, at most 32; without parts outside of the image
  /// or behind a pinhole.
  std::vector<ImageLine> Of(const R3::Point& from, const R3::Point& to) const;

 private:
  bool IsTorn(const R2::Point& from, const R2::Point& to, const R3::Point& middle) const;

  const Camera camera_;
  const int width_, height_;
  const IsVisible is_visible_;
};

}  // namespace ray

#pragma once

#include "R2/Point.h"
#include "R2/Vector.h"

namespace ray {

/// A rectangle of pixels, from the lower left corner.
struct PixelBox {
  double left = 0, bottom = 0, width = 1, height = 1;
};

/// The flat view of an image: scaled relative to the fitting size, moved, and cut off at a slider.
class FlatView {
 public:
  bool IsShown() const { return is_shown_; }
  /// Shows the whole image at the fitting size.
  void Show() { *this = FlatView(), is_shown_ = true; }
  void Hide() { is_shown_ = false; }

  /// Returns the place of an image that would fit at `fitting`.
  PixelBox Place(const PixelBox& fitting) const;
  /// Zooms around the point at `fixed`. `largest`: the maximum size of the image in pixels on a side.
  void Zoom(double factor, const R2::Point& fixed, const PixelBox& fitting, double largest);
  void Pan(const R2::Vector& way) { shift_ = {shift_.x + way.x, shift_.y + way.y}; }
  double ZoomFactor() const { return zoom_; }

  /// Returns the share of the view, from the left, that shows the image; 0 to 1.
  double Slider() const { return slider_; }
  void SetSlider(double share);

 private:
  bool is_shown_ = false;
  double zoom_ = 1, slider_ = 1;
  R2::Vector shift_;  // in pixels
};

}  // namespace ray

#pragma once

#include "R2/Point.h"
#include "R2/Vector.h"

namespace ray {

/// A rectangle of pixels, from the lower left corner.
struct PixelBox {
  double left = 0, bottom = 0, width = 1, height = 1;
};

/// How a picture is looked at flat: larger or smaller than it fits, moved, and cut off where a slider stands.
class FlatView {
 public:
  bool IsShown() const { return is_shown_; }
  /// Shows the whole image, as large as fits.
  void Show() { *this = FlatView(), is_shown_ = true; }
  void Hide() { is_shown_ = false; }

  /// Where a picture is that would otherwise be at `fitting`.
  PixelBox Place(const PixelBox& fitting) const;
  /// The point at `fixed` stays there. `largest`: the most pixels that the picture may have a side.
  void Zoom(double factor, const R2::Point& fixed, const PixelBox& fitting, double largest);
  void Pan(const R2::Vector& way) { shift_ = {shift_.x + way.x, shift_.y + way.y}; }
  double ZoomFactor() const { return zoom_; }

  /// The share of the view, from the left, that shows the picture; 0 to 1.
  double Slider() const { return slider_; }
  void SetSlider(double share);

 private:
  bool is_shown_ = false;
  double zoom_ = 1, slider_ = 1;
  R2::Vector shift_;  // pixels
};

}  // namespace ray

#include "source/draw/FlatView.h"

#include <algorithm>

namespace ray {

PixelBox FlatView::Place(const PixelBox& fitting) const {
  return {fitting.left + shift_.x, fitting.bottom + shift_.y, zoom_ * fitting.width, zoom_ * fitting.height};
}

void FlatView::Zoom(double factor, const R2::Point& fixed, const PixelBox& fitting, double largest) {
  constexpr double least = 0.1;  // of the fitting size: a smaller one is hard to find again
  const double most = std::max(1.0, largest / std::max(fitting.width, fitting.height));
  const double zoom = std::clamp(zoom_ * factor, least, most);
  const PixelBox now = Place(fitting);
  Pan((1 - zoom / zoom_) * (fixed - R2::Point{now.left, now.bottom}));
  zoom_ = zoom;
}

void FlatView::SetSlider(double share) { slider_ = std::clamp(share, 0.0, 1.0); }

}  // namespace ray

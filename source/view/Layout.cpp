#include "source/view/Layout.h"

#include <algorithm>

namespace ray {

Layout Layout::Of(const DrawingSize& all, double column, double bar, bool has_section) {
  const int width = std::max(1, all.width - static_cast<int>(column));
  const int height = std::max(1, all.height - static_cast<int>(bar));
  const int view = has_section ? std::max(1, width / 2) : width;
  return {{view, height}, {width - view, height}};
}

bool Layout::IsOnSection(const R2::Point& position) const {
  return position.x >= view.width && position.x < view.width + section.width && position.y >= 0 &&
         position.y < section.height;
}

PixelBox Layout::PlaceFor(double width, double height) const {
  const double scale = std::min(view.width / width, view.height / height);
  return {(view.width - scale * width) / 2, (view.height - scale * height) / 2, scale * width, scale * height};
}

}  // namespace ray

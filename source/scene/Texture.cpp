#include "source/scene/Texture.h"

#include <algorithm>

#include "R1/Elementary.h"

namespace ray {
namespace {

// Two neighboring texels along one axis, and the relative position between them.
struct Neighbors {
  int first, second;
  double share;
};

/// Returns the relative position between the centers of two neighboring texels. The rounding of a coordinate, 8 u, is
/// removed: at the center of a texel only that texel counts, so a black texel next to a white one is exactly black.
double Share(double position, double floor, int texels) {
  const double share = position - floor, noise = 0x1p-50 * texels;
  return share < noise ? 0 : share > 1 - noise ? 1 : share;
}

Neighbors Around(double coordinate, int texels) {
  const double wrapped = coordinate - R1::Floor(coordinate);  // in [0, 1]; 1 only by rounding
  const double position = wrapped * texels - 0.5;
  const double floor = R1::Floor(position);
  const int k = static_cast<int>(floor);  // in [-1, texels - 1]
  return {k < 0 ? texels - 1 : k, k + 1 < texels ? k + 1 : 0, Share(position, floor, texels)};
}

R2::Color Between(const R2::Color& a, const R2::Color& b, double share) { return (1 - share) * a + share * b; }

R2::Color InRow(const R2::Image& image, const Neighbors& x, int row) {
  return Between(image.At(x.first, row), image.At(x.second, row), x.share);
}

/// Returns the color at u in a row that may be beyond an end of v, unless v is repeated there.
R2::Color InRowOrBeyond(const R2::Image& image, double u, int row, const R3::VEnds& ends) {
  const int rows = image.Height(), inside = std::clamp(row, 0, rows - 1);
  const bool is_beyond_pole = row != inside && (row < 0 ? ends.low : ends.high) == R3::VEnd::pole;
  if (!is_beyond_pole) return InRow(image, Around(u, image.Width()), inside);
  const int on_other_side = row < 0 ? -1 - row : 2 * rows - 1 - row;
  return InRow(image, Around(u + 0.5, image.Width()), std::clamp(on_other_side, 0, rows - 1));
}

}  // namespace

R2::Color Texture::At(const R2::Point& uv, const R3::VEnds& ends) const {
  if (ends.low == R3::VEnd::repeated) {
    const Neighbors x = Around(uv.x, image.Width()), y = Around(uv.y, image.Height());
    return Between(InRow(image, x, y.first), InRow(image, x, y.second), y.share);
  }
  const double position = uv.y * image.Height() - 0.5, floor = R1::Floor(position);
  const int row = static_cast<int>(floor);
  return Between(InRowOrBeyond(image, uv.x, row, ends), InRowOrBeyond(image, uv.x, row + 1, ends),
                 Share(position, floor, image.Height()));
}

}  // namespace ray

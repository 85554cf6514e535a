#include "source/scene/Texture.h"

#include <cmath>

namespace ray {
namespace {

// Two neighboring texels along one axis and how far to go from the first to the second.
struct Neighbors {
  int first, second;
  double share;
};

Neighbors Around(double coordinate, int texels) {
  const double wrapped = coordinate - std::floor(coordinate);  // in [0, 1]; 1 only by rounding
  const double position = wrapped * texels - 0.5;
  const double floor = std::floor(position);
  const auto wrap = [&](int k) { return k < 0 ? k + texels : k >= texels ? k - texels : k; };
  const int k = static_cast<int>(floor);
  return {wrap(k), wrap(k + 1), position - floor};
}

R2::Color Between(const R2::Color& a, const R2::Color& b, double share) { return (1 - share) * a + share * b; }

}  // namespace

R2::Color Texture::At(const R2::Point& uv) const {
  const Neighbors x = Around(uv.x, image.Width()), y = Around(uv.y, image.Height());
  const R2::Color below = Between(image.At(x.first, y.first), image.At(x.second, y.first), x.share);
  const R2::Color above = Between(image.At(x.first, y.second), image.At(x.second, y.second), x.share);
  return Between(below, above, y.share);
}

}  // namespace ray

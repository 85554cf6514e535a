#include "source/film/denoise/FitTile.h"

#include <algorithm>

namespace ray {
namespace {

/// The bound of guides, so that sums of products of two of them are finite floats. No real light comes near it.
constexpr float most_guide = 1e15F;

/// Lambdas rather than functions so that loops inline them.
constexpr auto limited = [](float guide) {
  return guide < most_guide ? std::max(guide, -most_guide) : guide >= most_guide ? most_guide : 0;  // NaN is 0
};
constexpr auto as_it_is = [](float x) { return x; };

}  // namespace

template <std::size_t count, typename Function>
void FitTile::Copy(const Pixels<std::array<float, count>>& pixels, int around, const Function& function,
                   std::array<Channel, count>& channels) const {
  for (int y = -around; y < rows_ + around; ++y) {
    const int py = std::clamp(y0_ + y, 0, pixels.Height() - 1);
    for (int x = -around; x < columns_ + around; ++x) {
      const std::array<float, count>& pixel = pixels.At(std::clamp(x0_ + x, 0, pixels.Width() - 1), py);
      const auto at = static_cast<std::size_t>(At(x, y));
      for (std::size_t k = 0; k < count; ++k) channels[k][at] = function(pixel[k]);
    }
  }
}

void FitTile::Load(const LocalFitInput& input, int x0, int y0) {
  const int width = input.colors.Width(), height = input.colors.Height();
  x0_ = x0, y0_ = y0, image_rows_ = height;
  columns_ = std::min(columns, width - x0), rows_ = std::min(rows, height - y0);
  strength_squared_ = static_cast<float>(input.strength * input.strength);
  for (int x = -margin; x < columns_ + margin; ++x)
    has_column_[static_cast<std::size_t>(x + margin)] = x0 + x >= 0 && x0 + x < width ? 1 : 0;
  Copy(input.best, 0, limited, best);
  Copy(input.guides, window, limited, guides);
  Copy(input.colors, window, as_it_is, colors);
  Copy(input.compared, margin, as_it_is, compared);
  Copy(input.variance, margin, as_it_is, variance);
}

}  // namespace ray

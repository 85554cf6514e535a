#include "source/render/Layer.h"

#include <algorithm>
#include <limits>

#include "source/sample/Random.h"

namespace ray {
namespace {

template <typename Change>
R2::Image Changed(R2::Image image, const Change& change) {
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, change(image.At(x, y)));
  return image;
}

R2::Image ShownDepth(const R2::Image& image) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const float d : image.Channels())
    if (d > 0) nearest = std::min<double>(nearest, d), farthest = std::max<double>(farthest, d);
  return Changed(image, [&](const R2::Color& c) {
    if (!(c.r > 0)) return R2::Color{};
    constexpr double dimmest = 0.1;  // of the farthest surface, so that it differs from the background
    const double share = farthest > nearest ? (c.r - nearest) / (farthest - nearest) : 0;
    const double shown = 1 - (1 - dimmest) * share;
    return R2::Color{shown, shown, shown};
  });
}

R2::Color ColorOfId(const R2::Color& id) {
  if (id.r < 0) return {};
  const RandomKey key(static_cast<std::uint64_t>(id.r));
  constexpr double dimmest = 0.2;
  const auto channel = [&](std::uint64_t k) { return dimmest + (1 - dimmest) * key.Child(k).Number(); };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace

bool IsShownAsItIs(RenderMode mode) {
  return mode != RenderMode::depth && mode != RenderMode::id && mode != RenderMode::normal;
}

R2::Image LayerAsShown(RenderMode mode, const R2::Image& image) {
  if (mode == RenderMode::depth) return ShownDepth(image);
  if (mode == RenderMode::id) return Changed(image, ColorOfId);
  if (mode == RenderMode::normal)
    return Changed(image, [](const R2::Color& n) { return R2::Color{(n.r + 1) / 2, (n.g + 1) / 2, (n.b + 1) / 2}; });
  return image;
}

}  // namespace ray

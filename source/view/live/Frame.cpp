#include "source/view/live/Frame.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace ray {
namespace {

/// Converts as the film does: NaN becomes 0, and what is beyond the largest float becomes that.
float Storable(double x) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::isnan(x) ? 0 : std::clamp(x, -largest, largest));
}

}  // namespace

Frame::Frame(int width, int height)
    : width_(width),
      height_(height),
      channels_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      versions_(static_cast<std::size_t>(height)) {}

void Frame::Set(int x, int y, const R2::Color& color) {
  std::atomic<float>* channels = &channels_[Index(x, y)];
  channels[0].store(Storable(color.r), std::memory_order_relaxed);
  channels[1].store(Storable(color.g), std::memory_order_relaxed);
  channels[2].store(Storable(color.b), std::memory_order_relaxed);
}

R2::Color Frame::At(int x, int y) const {
  const std::atomic<float>* channels = &channels_[Index(x, y)];
  return {channels[0].load(std::memory_order_relaxed), channels[1].load(std::memory_order_relaxed),
          channels[2].load(std::memory_order_relaxed)};
}

void Frame::Touch(int row) { versions_[static_cast<std::size_t>(row)].fetch_add(1, std::memory_order_release); }

std::uint32_t Frame::Version(int row) const {
  return versions_[static_cast<std::size_t>(row)].load(std::memory_order_acquire);
}

void Frame::Copy(int first, int count, std::vector<float>& rgb) const {
  const auto begin = channels_.begin() + static_cast<std::ptrdiff_t>(Index(0, first));
  const auto end = begin + 3 * static_cast<std::ptrdiff_t>(width_) * count;
  std::transform(begin, end, std::back_inserter(rgb),
                 [](const std::atomic<float>& channel) { return channel.load(std::memory_order_relaxed); });
}

}  // namespace ray

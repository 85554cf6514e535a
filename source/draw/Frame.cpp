#include "source/draw/Frame.h"

#include <iterator>

#include "R2/Image.h"

namespace ray {
namespace {

float Stored(double x) { return static_cast<float>(R2::Storable(x)); }

}  // namespace

Frame::Frame(int width, int height)
    : width_(width),
      height_(height),
      channels_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      versions_(static_cast<std::size_t>(height)) {}

void Frame::Set(int x, int y, const R2::Color& color) {
  std::atomic<float>* channels = &channels_[Index(x, y)];
  channels[0].store(Stored(color.r), std::memory_order_relaxed);
  channels[1].store(Stored(color.g), std::memory_order_relaxed);
  channels[2].store(Stored(color.b), std::memory_order_relaxed);
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

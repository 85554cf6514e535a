#include "source/draw/Frame.h"

namespace ray {

void Frame::Put(const R2::Image& rows, int first) {
  const std::lock_guard lock(mutex_);
  for (int y = 0; y < rows.Height(); ++y) {
    for (int x = 0; x < rows.Width(); ++x) image_.Set(x, first + y, rows.At(x, y));
    ++versions_[static_cast<std::size_t>(first + y)];
  }
}

R2::Image Frame::Image() const {
  const std::lock_guard lock(mutex_);
  return image_;
}

R2::Color Frame::At(int x, int y) const {
  const std::lock_guard lock(mutex_);
  return image_.At(x, y);
}

std::uint32_t Frame::Version(int row) const {
  const std::lock_guard lock(mutex_);
  return versions_[static_cast<std::size_t>(row)];
}

void Frame::Copy(int first, int count, std::vector<float>& rgb) const {
  const std::lock_guard lock(mutex_);
  const std::ptrdiff_t row = 3 * std::ptrdiff_t{Width()};
  rgb.insert(rgb.end(), image_.Channels().begin() + first * row, image_.Channels().begin() + (first + count) * row);
}

}  // namespace ray

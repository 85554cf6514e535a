#include "R2/Image.h"

#include <cassert>

namespace R2 {

Image::Image(int width, int height) : width_(width), height_(height) {
  assert(width > 0 && height > 0 && static_cast<std::int64_t>(width) * height <= max_pixels);
  channels_.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

}  // namespace R2

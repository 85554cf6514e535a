#include "source/view/live/FinishedRows.h"

#include <algorithm>
#include <utility>

namespace ray {

FinishedRows::FinishedRows(const Film& film) : columns_(film.Columns()), region_(film.Region()), top_(region_.y0) {
  for (int block = 0; block < film.Blocks(); block += columns_) {
    missing_.push_back(columns_);
    // Samples of the blocks above count for pixels below them where the filter reaches so far.
    const bool is_last = block + columns_ >= film.Blocks();
    const int top = film.PixelsOf(block).y1 - (is_last ? 0 : film.filter().Apron());
    final_.push_back(is_last ? region_.y1 : std::clamp(top, region_.y0, region_.y1));
  }
}

PixelRectangle FinishedRows::Add(std::span<const int> blocks) {
  for (const int block : blocks) --missing_[static_cast<std::size_t>(block / columns_)];
  while (whole_ < missing_.size() && missing_[whole_] == 0) ++whole_;
  const int top = whole_ > 0 ? final_[whole_ - 1] : region_.y0;
  return {region_.x0, std::exchange(top_, top), region_.x1, top};
}

}  // namespace ray

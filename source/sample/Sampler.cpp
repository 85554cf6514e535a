#include "source/sample/Sampler.h"

namespace ray {

void Points::Fill(std::uint32_t index, double* coordinates, std::size_t size) const {
  if (kind_ == SamplerKind::random) {
    const RandomKey own = key_.Child(index);
    for (std::size_t i = 0; i < size; ++i) coordinates[i] = own.Child(i).Number();
    return;
  }
  for (std::size_t i = 0; i < size; i += 2) {
    const R2::Point pair = PairOf(index, i / 2)[index % count_];
    coordinates[i] = pair.x;
    if (i + 1 < size) coordinates[i + 1] = pair.y;
  }
}

Stratified Points::PairOf(std::uint32_t index, std::uint64_t pair) const {
  return Stratified(count_, key_.Child(pair).Child(index / count_));
}

}  // namespace ray

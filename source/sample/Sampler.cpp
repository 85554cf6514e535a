#include "source/sample/Sampler.h"

#include "R3/Numeric.h"

namespace ray {

R3_VECTORIZED
void Points::GetEach2D(std::uint64_t first, std::uint32_t count, double* x, double* y) const {
  if (UsesSobol(kind_) && dimension_ == 0) {
    const auto in_sequence = static_cast<std::uint32_t>(first);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto point = SobolPoint<2>(in_sequence + i, std::integral_constant<int, 0>());
      x[i] = point[0], y[i] = point[1];
    }
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const R2::Point point = Get2D(first + i);
    x[i] = point.x, y[i] = point.y;
  }
}

void Points::Fill(std::uint64_t index, double* coordinates, std::size_t size) const {
  if (kind_ == SamplerKind::random) {
    const RandomKey own = key_.Child(index);
    for (std::size_t i = 0; i < size; ++i) coordinates[i] = own.Child(i).Number();
    return;
  }
  for (std::size_t i = 0; i < size; i += 2) {
    const R2::Point pair = PairOf(index, i / 2)[static_cast<std::uint32_t>(index % count_)];
    coordinates[i] = pair.x;
    if (i + 1 < size) coordinates[i + 1] = pair.y;
  }
}

Stratified Points::PairOf(std::uint64_t index, std::uint64_t pair) const {
  return Stratified(count_, key_.Child(pair).Child(index / count_));
}

}  // namespace ray

#include "source/sample/Sampler.h"

#include <algorithm>

#include "source/sample/Sobol.h"

namespace ray {
namespace {

std::uint32_t High(const RandomKey& key) { return static_cast<std::uint32_t>(key.Bits() >> 32); }
std::uint32_t Low(const RandomKey& key) { return static_cast<std::uint32_t>(key.Bits()); }

}  // namespace

Points::Points(SamplerKind kind, const RandomKey& key, std::uint32_t count, const RandomKey& first, int dimension)
    : kind_(kind), key_(key), count_(std::max(count, 1u)), order_(High(first)), dimension_(dimension) {}

R2::Point Points::Get2D(std::uint32_t index) const {
  switch (kind_) {
    case SamplerKind::sobol:
    case SamplerKind::grid: {
      const RandomKey seeds = key_.Child(0);
      const Sobol point(index, order_);
      return {point.Coordinate(dimension_, High(seeds)), point.Coordinate(dimension_ + 1, Low(seeds))};
    }
    case SamplerKind::random: {
      const RandomKey own = key_.Child(index);
      return {own.Child(0).Number(), own.Child(1).Number()};
    }
    case SamplerKind::stratified:
      return PairOf(index, 0)[index % count_];
  }
  return {};
}

void Points::Fill(std::uint32_t index, double* coordinates, std::size_t size) const {
  switch (kind_) {
    case SamplerKind::sobol:
    case SamplerKind::grid: {
      const Sobol point(index, order_);
      for (std::size_t i = 0; i < size; ++i) {
        const RandomKey seeds = key_.Child(i / 2);
        coordinates[i] = point.Coordinate(dimension_ + static_cast<int>(i), i % 2 == 0 ? High(seeds) : Low(seeds));
      }
      return;
    }
    case SamplerKind::random: {
      const RandomKey own = key_.Child(index);
      for (std::size_t i = 0; i < size; ++i) coordinates[i] = own.Child(i).Number();
      return;
    }
    case SamplerKind::stratified:
      for (std::size_t i = 0; i < size; i += 2) {
        const R2::Point pair = PairOf(index, i / 2)[index % count_];
        coordinates[i] = pair.x;
        if (i + 1 < size) coordinates[i + 1] = pair.y;
      }
      return;
  }
}

Stratified Points::PairOf(std::uint32_t index, std::uint64_t pair) const {
  return Stratified(count_, key_.Child(pair).Child(index / count_));
}

}  // namespace ray

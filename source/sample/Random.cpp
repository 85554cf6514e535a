#include "source/sample/Random.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ray {
namespace {

/// Returns the next power of two minus 1, which fits into 32 bits for any count.
std::uint32_t MaskOf(std::uint32_t count) { return count > 1 ? ~0u >> std::countl_zero(count - 1) : 0; }

}  // namespace

Shuffle::Shuffle(std::uint32_t count, const RandomKey& key)
    : count_(count),
      mask_(MaskOf(count)),
      half_(std::max(1, static_cast<int>(std::bit_width(mask_)) / 2)),
      salts_{key.Bits(), key.Child(0).Bits()} {}

std::uint32_t Shuffle::operator()(std::uint32_t index) const {
  if (count_ <= 1) return 0;
  std::uint32_t i = index;
  do {
    // Each line is a bijection of 0 ... mask: adding, multiplying by an odd number, folding the high half into the low.
    // Eight rounds: with four, a chi-square test of where each of seven values goes still detects a pattern.
    for (int round = 0; round < 8; ++round) {
      const auto salt = static_cast<std::uint32_t>(salts_[round / 4] >> (16 * (round % 4)));
      i = (i + salt) & mask_;
      i = (i * (((salt >> 7) & 0xff) * 2 + 1)) & mask_;
      i ^= i >> half_;
    }
  } while (i >= count_);
  return i;
}

Stratified::Stratified(std::uint32_t count, const RandomKey& key)
    : count_(count),
      rows_(static_cast<std::uint32_t>(std::max(1.0, std::round(std::sqrt(static_cast<double>(count)))))),
      jitter_(key.Child(1)),
      shuffle_(count, key.Child(0)) {}

R2::Point Stratified::operator[](std::uint32_t index) const {
  constexpr std::uint32_t products_fit = 1 << 20;  // into 32 bits, in which division takes half as long
  const std::uint32_t cell = shuffle_(index);
  return count_ < products_fit ? InCell<std::uint32_t>(cell, index) : InCell<std::uint64_t>(cell, index);
}

template <typename Whole>
R2::Point Stratified::InCell(Whole cell, std::uint32_t index) const {
  const Whole n = count_, rows = rows_;
  // Row r contains the cells from floor(r n / rows) up to, not including, floor((r + 1) n / rows).
  Whole row = cell * rows / n;
  while ((row + 1) * n / rows <= cell) ++row;
  const Whole first = row * n / rows, after = (row + 1) * n / rows;
  const RandomKey jitter = jitter_.Child(index);
  const double x = (static_cast<double>(cell - first) + jitter.Child(0).Number()) / static_cast<double>(after - first);
  const double y = (static_cast<double>(first) + jitter.Child(1).Number() * static_cast<double>(after - first)) /
                   static_cast<double>(n);
  // The sums may round up to 1.
  return {std::min(x, below_one), std::min(y, below_one)};
}

}  // namespace ray

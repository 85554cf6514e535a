#include "source/integrate/Random.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ray {

std::uint32_t Shuffled(std::uint32_t index, std::uint32_t count, const RandomKey& key) {
  if (count <= 1) return 0;
  const std::uint32_t mask = std::bit_ceil(count) - 1;
  const int half = std::max(1, static_cast<int>(std::bit_width(mask)) / 2);
  const std::uint64_t salts[] = {key.Bits(), key.Child(0).Bits()};
  std::uint32_t i = index;
  do {
    // Each line is a bijection of 0 ... mask: adding, multiplying by an odd number, folding the high half into the low.
    // Eight rounds: with four, a chi-square test over where each of seven goes still sees a pattern.
    for (int round = 0; round < 8; ++round) {
      const auto salt = static_cast<std::uint32_t>(salts[round / 4] >> (16 * (round % 4)));
      i = (i + salt) & mask;
      i = (i * (((salt >> 7) & 0xff) * 2 + 1)) & mask;
      i ^= i >> half;
    }
  } while (i >= count);
  return i;
}

R2::Point Stratified(std::uint32_t index, std::uint32_t count, const RandomKey& key) {
  const std::uint64_t n = count;
  const auto rows = static_cast<std::uint64_t>(std::max(1.0, std::round(std::sqrt(static_cast<double>(count)))));
  const std::uint64_t cell = Shuffled(index, count, key.Child(0));
  // Row r holds the cells from floor(r n / rows) up to, not including, floor((r + 1) n / rows).
  std::uint64_t row = cell * rows / n;
  while ((row + 1) * n / rows <= cell) ++row;
  const std::uint64_t first = row * n / rows, after = (row + 1) * n / rows;
  const RandomKey jitter = key.Child(1).Child(index);
  const double x = (static_cast<double>(cell - first) + jitter.Child(0).Number()) / static_cast<double>(after - first);
  const double y = (static_cast<double>(first) + jitter.Child(1).Number() * static_cast<double>(after - first)) /
                   static_cast<double>(n);
  // The sums may round up to 1.
  constexpr double below_one = 1 - 0x1p-53;
  return {std::min(x, below_one), std::min(y, below_one)};
}

}  // namespace ray

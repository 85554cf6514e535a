#pragma once

#include <cstddef>

namespace R1 {

/// The largest number of samples per batch; loops over a batch become vector instructions. In mode path, half this size
/// takes 1 to 7 % more time; twice this size takes 2 to 5 % less on one thread but 7 % more on two.
inline constexpr std::size_t batch_size = 128;

/// Up to `most` things of two or three numbers, such as points and colors, stored as one array per coordinate so that
/// loops over them become vector instructions. Numbers that have not been set are undefined.
template <typename Thing, std::size_t most = batch_size>
struct Columns {
  static constexpr std::size_t size = sizeof(Thing) / sizeof(double);
  static_assert(size == 2 || size == 3);

  alignas(64) double column[size][most];

  Thing operator[](std::size_t i) const {
    if constexpr (size == 2) return {column[0][i], column[1][i]};
    if constexpr (size == 3) return {column[0][i], column[1][i], column[2][i]};
  }
  void Set(std::size_t i, const Thing& thing) {
    if constexpr (size == 2) {
      const auto& [x, y] = thing;
      column[0][i] = x, column[1][i] = y;
    } else {
      const auto& [x, y, z] = thing;
      column[0][i] = x, column[1][i] = y, column[2][i] = z;
    }
  }
};

}  // namespace R1

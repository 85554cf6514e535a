// Points that keep a distance from each other.
#include "source/sample/PoissonDisk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ray {
namespace {

/// Returns the smallest distance between the first n points, also across the edges of the square.
double LeastDistance(std::uint32_t n, const RandomKey& key) {
  double least = 2;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < i; ++j) {
      const R2::Point a = PoissonDiskPlace(i, key), b = PoissonDiskPlace(j, key);
      const double x = std::abs(a.x - b.x), y = std::abs(a.y - b.y);
      least = std::min(least, std::hypot(std::min(x, 1 - x), std::min(y, 1 - y)));
    }
  return least;
}

TEST(PoissonDisk, PointsKeepTheirDistanceForAnyNumber) {
  for (std::uint32_t n = 2; n <= 64; ++n)
    EXPECT_GE(LeastDistance(n, RandomKey(n)) * std::sqrt(n), 0.55) << n;
}

TEST(PoissonDisk, EveryPositionIsEquallyLikely) {
  constexpr int cells = 8, keys = 40'000;
  std::vector<int> counts(cells * cells);
  for (int key = 0; key < keys; ++key) {
    const R2::Point p = PoissonDiskPlace(3, RandomKey(static_cast<std::uint64_t>(key)));
    ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
    ++counts[static_cast<std::size_t>(static_cast<int>(p.y * cells) * cells + static_cast<int>(p.x * cells))];
  }
  double square = 0;  // of 63 degrees of freedom: above 110 once in 5000 times
  for (const int count : counts) square += std::pow(count - keys / 64.0, 2) / (keys / 64.0);
  EXPECT_LT(square, 110);
}

TEST(PoissonDisk, PointsFromSixtyFourOnAreDifferent) {
  const RandomKey key(5);
  EXPECT_NE(PoissonDiskPlace(64, key).x, PoissonDiskPlace(0, key).x);
  EXPECT_EQ(PoissonDiskPlace(63, key).x, PoissonDiskPlace(63, key).x);
}

}  // namespace
}  // namespace ray

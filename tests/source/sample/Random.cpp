#include "source/sample/Sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace {

TEST(Shuffled, IsAPermutationForEveryCount) {
  for (const std::uint32_t count : {1u, 2u, 3u, 5u, 16u, 17u, 100u, 255u, 256u, 1000u})
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      std::set<std::uint32_t> seen;
      for (std::uint32_t i = 0; i < count; ++i) seen.insert(ray::Shuffle(count, ray::RandomKey(seed))(i));
      EXPECT_EQ(seen.size(), count);
      EXPECT_LT(*seen.rbegin(), count);
    }
}

TEST(Shuffled, SendsEveryIndexEverywhereEquallyOften) {
  // Chi-square over the 7 x 7 table of where each index goes, 36 degrees of freedom: above 76 once in 10,000 times.
  constexpr std::uint32_t count = 7;
  constexpr int rounds = 14'000;
  int table[count][count] = {};
  for (int seed = 0; seed < rounds; ++seed)
    for (std::uint32_t i = 0; i < count; ++i)
      ++table[i][ray::Shuffle(count, ray::RandomKey(static_cast<std::uint64_t>(seed)))(i)];
  const double expected = static_cast<double>(rounds) / count;
  double chi_square = 0;
  for (const auto& row : table)
    for (const int n : row) chi_square += (n - expected) * (n - expected) / expected;
  EXPECT_LT(chi_square, 76);
}

// The next power of two does not fit into 32 bits. (All indices once went to 0 there.)
TEST(Shuffled, SendsIndicesEverywhereForCountsBeyondHalfOfAllNumbers) {
  for (const std::uint32_t count : {(1u << 31) - 1, 1u << 31, (1u << 31) + 1, 3'000'000'000u, ~0u}) {
    const ray::Shuffle shuffle(count, ray::RandomKey(4));
    std::set<std::uint32_t> seen;
    constexpr std::uint32_t asked = 20'000;
    for (std::uint32_t i = 0; i < asked / 2; ++i) seen.insert({shuffle(i), shuffle(count - 1 - i)});
    EXPECT_EQ(seen.size(), asked) << count;
    EXPECT_LT(*seen.rbegin(), count);
    // The mean of this many random points has a standard error of sqrt(1 / 12 / 20,000) = .002.
    double sum = 0;
    for (const std::uint32_t place : seen) sum += static_cast<double>(place) / count;
    EXPECT_NEAR(sum / asked, 0.5, 4 * 0.002) << count;
  }
}

// Samples of a pixel times their shadow rays may exceed 32 bits: there are then as many strata as fit, and no number is
// drawn twice.
TEST(Points, AreSpreadEvenlyHoweverManyThereAre) {
  constexpr std::uint32_t samples = 2'000'000'000, each = 9, asked = 300;
  for (const ray::SamplerKind kind :
       {ray::SamplerKind::stratified, ray::SamplerKind::random, ray::SamplerKind::sobol}) {
    std::set<double> xs;
    double sum = 0;
    for (const std::uint32_t sample : {0u, 477'218'589u, samples - asked})  // 9 * 477218589 is 2^32 + 5
      for (std::uint32_t i = 0; i < asked; ++i) {
        const ray::SampleIndex at{ray::RandomKey(5), sample + i};
        const ray::Points points = at.PointsFor(1, kind, samples, each);
        for (std::uint32_t k = 0; k < each; ++k) {
          const R2::Point p = points.Get2D(at.FirstOf(each) + k);
          if (kind != ray::SamplerKind::sobol) xs.insert(p.x);
          sum += p.x + 2 * p.y;
        }
      }
    // 8,100 points, whose mean has a standard error of sqrt(5 / 12 / 8,100) = .0072.
    EXPECT_NEAR(sum / (3 * asked * each), 1.5, 4 * 0.0072) << static_cast<int>(kind);
    EXPECT_EQ(xs.size(), kind == ray::SamplerKind::sobol ? 0 : 3 * asked * each) << static_cast<int>(kind);
  }
}

TEST(Points, Beyond32BitsUseAsManyStrataAsFit) {
  const ray::SampleIndex at{ray::RandomKey(5), 3};
  const auto stratified = ray::SamplerKind::stratified;
  const ray::Points points = at.PointsFor(1, stratified, 1u << 30, 4),
                    most = ray::Points(stratified, at.key.Child(1), ~0u);
  for (std::uint64_t i = 0; i < 100; ++i) EXPECT_EQ(points.Get2D(i), most.Get2D(i)) << i;
}

TEST(Stratified, PutsOnePointIntoEachCellForEveryCount) {
  for (const std::uint32_t count : {1u, 2u, 3u, 4u, 7u, 16u, 17u, 64u, 100u, 1000u}) {
    const ray::RandomKey key(count);
    // The rows as documented: as many as the rounded root, each with its share of the points.
    const auto rows = static_cast<std::uint32_t>(std::max(1.0, std::round(std::sqrt(count))));
    std::vector<std::vector<int>> cells(rows);
    for (std::uint32_t r = 0; r < rows; ++r) cells[r].resize((r + 1) * count / rows - r * count / rows);
    for (std::uint32_t i = 0; i < count; ++i) {
      const R2::Point p = ray::Stratified(count, key)[i];
      ASSERT_GE(p.x, 0);
      ASSERT_LT(p.x, 1);
      ASSERT_GE(p.y, 0);
      ASSERT_LT(p.y, 1);
      std::uint32_t row = 0;
      while (row + 1 < rows && p.y >= static_cast<double>((row + 1) * count / rows) / count) ++row;
      ++cells[row][static_cast<std::size_t>(p.x * static_cast<double>(cells[row].size()))];
    }
    for (const auto& row : cells)
      for (const int points : row) EXPECT_EQ(points, 1) << count;
  }
}

TEST(Stratified, IsUnbiasedForACountThatIsNotASquare) {
  // The mean of x + 2y over sets of 7 is 1.5; one set's standard error is under 0.1, that of 4000 sets under 0.0016.
  double sum = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed)
    for (std::uint32_t i = 0; i < 7; ++i) {
      const R2::Point p = ray::Stratified(7, ray::RandomKey(seed))[i];
      sum += p.x + 2 * p.y;
    }
  EXPECT_NEAR(sum / 28'000, 1.5, 4 * 0.0016);
}

TEST(RandomKey, NeighborsAreNotCorrelated) {
  // Products of deviations of a million pairs have standard error 1/12 / 1000.
  double sum = 0;
  for (std::uint64_t i = 0; i < 1'000'000; ++i) {
    const ray::RandomKey row = ray::RandomKey(0).Child(i % 1000);
    sum += (row.Child(i / 1000).Number() - 0.5) * (row.Child(i / 1000 + 1).Number() - 0.5);
  }
  EXPECT_NEAR(sum / 1e6, 0, 4 * (1.0 / 12) / 1000);
}

// Two pixels that draw the same numbers share their noise. (Child b of seed a was once child a of seed b, so that
// column 1 of seed 0 had the numbers of column 0 of seed 1, and column s those of seed s for every s.)
TEST(Extremes, I6_NoPixelAndNoSeedRepeatsTheStreamOfAnother) {
  std::vector<std::uint64_t> keys;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}})
    for (std::uint64_t x = 0; x < 600; ++x)
      for (std::uint64_t y = 0; y < 600; ++y) {
        const ray::RandomKey own = ray::RandomKey(seed).Child(x).Child(y);
        keys.push_back(own.Bits());
        keys.push_back(own.Child(2).Bits());  // the second stream
      }
  std::ranges::sort(keys);
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
}

}  // namespace

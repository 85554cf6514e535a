#include "source/sample/Sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "source/sample/Sampler.h"

namespace ray {
namespace {

TEST(Sobol, PowersOfTwoPutOnePointInEveryBox) {
  for (std::uint64_t key = 0; key < 20; ++key)
    for (int log = 1; log <= 10; ++log) {
      const std::uint32_t n = 1u << log, first = static_cast<std::uint32_t>(key % 3) * n;
      const Points points(SamplerKind::sobol, RandomKey(key), n);
      for (int across = 0; across <= log; ++across) {
        std::set<std::pair<int, int>> boxes;
        for (std::uint32_t i = 0; i < n; ++i) {
          const R2::Point p = points.Get2D(first + i);
          boxes.insert({static_cast<int>(std::ldexp(p.x, across)), static_cast<int>(std::ldexp(p.y, log - across))});
        }
        ASSERT_EQ(boxes.size(), n) << "boxes 2^-" << across << " wide, key " << key;
      }
    }
}

TEST(Sobol, EveryDimensionPutsOnePointIntoEveryInterval) {
  constexpr std::uint32_t n = 4096;
  for (int d = 0; d < Sobol::dimensions; ++d) {
    std::set<int> intervals;
    for (std::uint32_t i = 0; i < n; ++i)
      intervals.insert(static_cast<int>(n * Sobol(i, 12345).Coordinate(d, 777u + static_cast<std::uint32_t>(d))));
    EXPECT_EQ(intervals.size(), n) << "dimension " << d;
  }
}

TEST(Points, InBatchesEqualSingleOnes) {
  for (const SamplerKind kind : {SamplerKind::sobol, SamplerKind::random, SamplerKind::stratified, SamplerKind::grid})
    for (const int dimension : {0, 4}) {
      const Points points(kind, RandomKey(9), 40, RandomKey(8), dimension);
      double x[40], y[40];
      points.GetEach2D(1000, 40, x, y);
      for (std::uint32_t i = 0; i < 40; ++i) {
        const R2::Point alone = points.Get2D(1000 + i);
        EXPECT_EQ(x[i], alone.x) << sampler_names[static_cast<std::size_t>(kind)];
        EXPECT_EQ(y[i], alone.y) << sampler_names[static_cast<std::size_t>(kind)];
      }
    }
}

// Changing a bit may change that bit and bits below it, never a bit above: otherwise boxes would not map to boxes.
TEST(Owen, NoBitIsFlippedByABitBelowIt) {
  const RandomKey key(3);
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const std::uint32_t seed = static_cast<std::uint32_t>(key.Child(i).Bits());
    const std::uint32_t bits = static_cast<std::uint32_t>(key.Child(i).Child(1).Bits());
    const int changed = static_cast<int>(i % 32);  // in reversed numbers, a HIGH position is a low bit
    const std::uint32_t a = OwenReversed(bits, seed), b = OwenReversed(bits ^ (1u << changed), seed);
    const std::uint32_t above = (1u << changed) - 1;
    ASSERT_EQ(a & above, b & above);
    ASSERT_NE((a >> changed) & 1, (b >> changed) & 1) << "the bit itself is a bijection of itself";
  }
}

/// Applies the permutation by its definition: each bit flipped by a hash of the bits above it.
std::uint32_t OwenByDefinition(std::uint32_t bits, const RandomKey& key) {
  std::uint32_t result = 0;
  for (int i = 0; i < 32; ++i) {
    const std::uint64_t above = i == 0 ? 1 : (std::uint64_t{1} << i) | (bits >> (32 - i));
    const std::uint32_t flip = static_cast<std::uint32_t>(key.Child(above).Bits() >> 63);
    result |= (((bits >> (31 - i)) & 1) ^ flip) << (31 - i);
  }
  return result;
}

/// Returns the root mean square error of the mean of `f` at n points, whose exact value is 1, over many scrambles.
template <typename Point>
double ErrorOf(std::uint32_t n, const Point& point) {
  constexpr int scrambles = 300;
  double squares = 0;
  for (std::uint64_t scramble = 0; scramble < scrambles; ++scramble) {
    double sum = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      double product = 1;  // of (x + 1/2): smooth, all coordinates interact
      for (const double x : point(scramble, i)) product *= x + 0.5;
      sum += product;
    }
    squares += (sum / n - 1) * (sum / n - 1);
  }
  return std::sqrt(squares / scrambles);
}

template <std::size_t size>
void ExpectSlopeOfTheDefinition(double steepest_known) {
  const auto hashed = [](std::uint64_t scramble, std::uint32_t i) {
    return Points(SamplerKind::sobol, RandomKey(scramble), 1).Get<size>(i);
  };
  const auto defined = [](std::uint64_t scramble, std::uint32_t i) {
    std::array<double, size> point;
    for (std::size_t d = 0; d < size; ++d)
      point[d] =
          OwenByDefinition(ReversedBits(ReversedSobolBits(i, static_cast<int>(d))), RandomKey(scramble).Child(d)) *
          0x1p-32;
    return point;
  };
  const double coarse = ErrorOf(16, hashed), fine = ErrorOf(1024, hashed);
  const double slope = std::log2(fine / coarse) / 6;
  const double slope_of_definition = std::log2(ErrorOf(1024, defined) / ErrorOf(16, defined)) / 6;
  EXPECT_NEAR(slope, slope_of_definition, 0.06) << size << " dimensions";
  EXPECT_LT(slope, steepest_known) << size << " dimensions";
  testing::Test::RecordProperty("slope", std::to_string(slope));
}

// A hash that also lets low bits act on high ones falls back to -1/2 here.
TEST(Owen, ErrorsInFourDimensionsFallAtTheDefinitionsRate) { ExpectSlopeOfTheDefinition<4>(-1.2); }
TEST(Owen, ErrorsInSixDimensionsFallAtTheDefinitionsRate) { ExpectSlopeOfTheDefinition<6>(-1.0); }

TEST(Sampler, NumbersOfNeighboringPixelsAndSeedsAreNotRelated) {
  // Correlation of first coordinates over a million pairs: below 4 sigma = 4 / 1000.
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}})
    for (std::size_t k = 0; k < sampler_names.size(); ++k) {
      double sum = 0;
      constexpr int side = 1000;
      const auto first = [&](std::uint64_t x, std::uint64_t y, std::uint64_t s) {
        return Points(static_cast<SamplerKind>(k), RandomKey(s).Child(x).Child(y), 4).Get2D(0).x - 0.5;
      };
      double over_seeds = 0;
      for (std::uint64_t y = 0; y < side; ++y)
        for (std::uint64_t x = 0; x < side; ++x) {
          const double here = first(x, y, seed);
          sum += 12 * here * first(x + 1, y, seed);
          over_seeds += 12 * here * first(x, y, seed + 1);
        }
      EXPECT_LT(std::abs(sum) / (side * side), 4e-3) << sampler_names[k] << ", seed " << seed;
      EXPECT_LT(std::abs(over_seeds) / (side * side), 4e-3) << sampler_names[k] << ", seed " << seed;
    }
}

TEST(Sampler, EveryKindFillsTheCubeEvenly) {
  for (std::size_t k = 0; k < sampler_names.size(); ++k) {
    std::array<double, Sobol::dimensions> mean{}, square{};
    constexpr std::uint32_t n = 1 << 16;
    const Points points(static_cast<SamplerKind>(k), RandomKey(5), n);
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto p = points.Get<Sobol::dimensions>(i);
      const R2::Point plane = points.Get2D(i);
      ASSERT_EQ(plane.x, p[0]);
      ASSERT_EQ(plane.y, p[1]);
      for (std::size_t d = 0; d < p.size(); ++d) {
        ASSERT_GE(p[d], 0);
        ASSERT_LT(p[d], 1);
        mean[d] += p[d] / n;
        square[d] += p[d] * p[d] / n;
      }
    }
    for (std::size_t d = 0; d < mean.size(); ++d) {
      EXPECT_NEAR(mean[d], 0.5, 4 * std::sqrt(1.0 / 12 / n)) << sampler_names[k] << " " << d;
      EXPECT_NEAR(square[d], 1.0 / 3, 4 * std::sqrt(4.0 / 45 / n)) << sampler_names[k] << " " << d;
    }
  }
}

}  // namespace
}  // namespace ray

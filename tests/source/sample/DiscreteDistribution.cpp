#include "source/sample/DiscreteDistribution.h"

#include <gtest/gtest.h>

#include <limits>

#include "source/sample/Random.h"
#include "tests/ChiSquare.h"

namespace {

constexpr double last = 1 - 0x1p-53;

std::vector<double> RandomWeights(std::size_t count) {
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = ray::RandomKey(3).Child(i).Number();
    weights.push_back(i % 5 == 2 ? 0 : x * x * x);  // of very different sizes, some of them 0
  }
  return weights;
}

TEST(Extremes, I3_LightsAreDrawnByTheirWeights) {
  const std::vector<double> weights = RandomWeights(300);
  double all = 0;
  for (const double w : weights) all += w;
  const ray::DiscreteDistribution discrete(weights);
  std::vector<double> counts(weights.size()), shares, rests(256);
  for (std::uint64_t i = 0; i < 1'000'000; ++i) {
    const auto drawn = discrete.Draw(ray::RandomKey(4).Child(i).Number());
    ASSERT_EQ(drawn.probability, discrete.Probability(drawn.index));
    ++counts[drawn.index];
    ++rests[static_cast<std::size_t>(drawn.rest * 256)];
  }
  for (const double w : weights) shares.push_back(w / all);
  EXPECT_LT(chi_square::OverQuantile(counts, shares, 0.005), 1);
  // The rest of u is uniform again.
  EXPECT_LT(chi_square::OverQuantile(rests, std::vector<double>(256, 1.0 / 256), 0.005), 1);
}

TEST(DiscreteDistribution, ProbabilitiesAreTheWeightsSharesAndSumToOne) {
  const std::vector<double> weights = RandomWeights(10'000);
  double all = 0, sum = 0;
  for (const double w : weights) all += w;
  const ray::DiscreteDistribution discrete(weights);
  ASSERT_EQ(discrete.Size(), weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(discrete.Probability(i), weights[i] / all, 10'000 * 0x1p-53);
    sum += discrete.Probability(i);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(DiscreteDistribution, ZeroWeightsAreNeverDrawnEvenAtTheEnds) {
  const ray::DiscreteDistribution discrete(std::vector<double>{0, 1, 0, 0, 3, 0});
  for (const double u : {0.0, 0.1, 0.25 - 0x1p-54, 0.25, 0.5, last, 1.0}) {
    const auto drawn = discrete.Draw(u);
    EXPECT_EQ(drawn.index, u < 0.25 ? 1u : 4u) << u;
    EXPECT_EQ(drawn.probability, u < 0.25 ? 0.25 : 0.75);
    EXPECT_GE(drawn.rest, 0);
    EXPECT_LT(drawn.rest, 1);
  }
  EXPECT_EQ(discrete.Probability(0), 0);
}

TEST(DiscreteDistribution, AgreesWithASearchThroughAllSums) {
  const std::vector<double> tiny_and_huge{1e-300, 0, 1, 1e-17, 1e-17, 1e9, 0, 0};
  for (const auto& weights : {RandomWeights(300), RandomWeights(7), RandomWeights(1), tiny_and_huge}) {
    const ray::DiscreteDistribution discrete(weights);
    std::vector<double> ends{0};  // of the parts of [0, 1] that draw each index
    for (std::size_t i = 0; i < weights.size(); ++i) ends.push_back(ends.back() + discrete.Probability(i));
    for (std::uint64_t k = 0; k < 20000; ++k) {
      const double u = k < 9 ? ends[k % ends.size()] : ray::RandomKey(6).Child(k).Number();
      const std::size_t drawn = discrete.Draw(u).index;
      EXPECT_GT(discrete.Probability(drawn), 0);
      EXPECT_TRUE(ends[drawn] <= u + 1e-13 && u - 1e-13 <= ends[drawn + 1]) << u << " drew " << drawn;
    }
  }
}

TEST(DiscreteDistribution, AllZeroMeansAllEqual) {
  const ray::DiscreteDistribution discrete(std::vector<double>(4));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(discrete.Probability(i), 0.25);
    EXPECT_EQ(discrete.Draw(static_cast<double>(i) / 4).index, i);
  }
}

TEST(DiscreteDistribution, HugeAndTinyWeightsNeitherOverflowNorVanish) {
  constexpr double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  for (const double w : {huge, tiny, 1.0}) {
    const ray::DiscreteDistribution discrete(std::vector<double>{w, 0, w, w, w});
    EXPECT_EQ(discrete.Probability(3), 0.25) << w;
    EXPECT_EQ(discrete.Draw(last).index, 4u) << w;
  }
  // A weight that the sum rounds away is never drawn, and has probability 0.
  const ray::DiscreteDistribution lopsided(std::vector<double>{huge, tiny});
  EXPECT_EQ(lopsided.Probability(1), 0);
  EXPECT_EQ(lopsided.Draw(last).index, 0u);
}

}  // namespace

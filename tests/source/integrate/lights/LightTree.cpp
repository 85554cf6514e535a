#include "source/integrate/lights/LightTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "R3/Warp.h"
#include "source/sample/Random.h"
#include "tests/ChiSquare.h"

namespace {

using ray::LightBound;
using ray::LightTree;
constexpr double last = 1 - 0x1p-53;

/// A sequence of random numbers.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : key_(seed) {}
  double operator()() { return key_.Child(next_++).Number(); }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }

 private:
  ray::RandomKey key_;
  std::uint64_t next_ = 0;
};

R3::Point RandomPoint(Numbers& numbers) {
  const double x = numbers(-1, 1), y = numbers(-1, 1), z = numbers(-1, 1);
  return {x, y, z};
}

R3::Vector RandomUnit(Numbers& numbers) {
  const double x = numbers(), y = numbers();
  return R3::SampleUniformSphere({x, y});
}

// Lights of all kinds: some at the same place, some with a size, some without power, some infinite, every attenuation.
std::vector<LightBound> RandomLights(int count, std::uint64_t seed) {
  Numbers numbers(seed);
  std::vector<LightBound> lights;
  for (int i = 0; i < count; ++i) {
    LightBound light;
    light.center = i % 4 == 3 ? lights.back().center : RandomPoint(numbers);
    if (i % 3 == 1) light.radius = numbers(0, 0.3);
    light.power = i % 11 == 10 ? 0 : std::exp(numbers(-5, 5));
    if (i % 5 == 0) light.ca = numbers();
    if (i % 5 == 1) light.la = numbers();
    if (i % 5 == 2) light.qa = 0;  // without attenuation
    light.is_infinite = i % 13 == 12;
    lights.push_back(light);
  }
  return lights;
}

bool IsBehind(const LightBound& light, const R3::Point& p, const R3::Vector& N) {
  return !light.is_infinite && Dot(light.center - p, N) + light.radius <= 0;
}

double Sum(const LightTree& tree, int lights, const R3::Point& p, const R3::Vector& N) {
  double sum = 0;
  for (int i = 0; i < lights; ++i) sum += tree.Probability(p, N, i);
  return sum;
}

TEST(LightTree, ProbabilitiesSumToOneAndOnlyLightsBehindHaveNone) {
  for (const int count : {1, 2, 3, 15, 16, 17, 100, 256, 257, 1000})
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const auto lights = RandomLights(count, seed);
      const LightTree tree(lights);
      Numbers numbers(100 + seed);
      for (int k = 0; k < 20; ++k) {
        const R3::Point p = R3::Point{} + 1.5 * FromOrigin(RandomPoint(numbers));
        const R3::Vector N = RandomUnit(numbers);
        bool can_be_lit = false;
        for (int i = 0; i < count; ++i) {
          const LightBound& light = lights[static_cast<std::size_t>(i)];
          const bool counts = light.power > 0 && !IsBehind(light, p, N);
          can_be_lit |= counts;
          ASSERT_EQ(tree.Probability(p, N, i) > 0, counts) << count << " lights, number " << i;
        }
        ASSERT_NEAR(Sum(tree, count, p, N), can_be_lit ? 1 : 0, 1e-12) << count;
        ASSERT_EQ(tree.Choose(p, N, numbers()).has_value(), can_be_lit);
      }
    }
}

TEST(LightTree, ChoosesWithTheStatedProbabilities) {
  for (const int count : {5, 60, 700}) {
    const auto lights = RandomLights(count, 9);
    const LightTree tree(lights);
    Numbers numbers(10);
    for (int k = 0; k < 3; ++k) {
      const R3::Point p = RandomPoint(numbers);
      const R3::Vector N = Unit(lights[0].center - p);  // so that there is one to choose
      std::vector<double> counts(lights.size()), probabilities;
      for (int i = 0; i < count; ++i) probabilities.push_back(tree.Probability(p, N, i));
      for (int i = 0; i < 200'000; ++i) {
        const auto choice = tree.Choose(p, N, numbers());
        ASSERT_TRUE(choice);
        ASSERT_EQ(choice->probability, probabilities[static_cast<std::size_t>(choice->light)]);
        ++counts[static_cast<std::size_t>(choice->light)];
      }
      EXPECT_LT(chi_square::OverQuantile(counts, probabilities, 0.01 / 9), 1) << count;
    }
  }
}

TEST(LightTree, TheEndsOfTheRandomNumberAreInside) {
  const auto lights = RandomLights(300, 2);
  const LightTree tree(lights);
  Numbers numbers(3);
  for (int k = 0; k < 200; ++k) {
    const R3::Point p = RandomPoint(numbers);
    const R3::Vector N = RandomUnit(numbers);
    for (const double u : {0.0, 0x1p-53, 0.5, last, 1.0}) {
      const auto choice = tree.Choose(p, N, u);
      ASSERT_TRUE(choice);
      ASSERT_GT(choice->probability, 0);
      ASSERT_EQ(choice->probability, tree.Probability(p, N, choice->light));
    }
  }
}

double Irradiance(const LightBound& light, const R3::Point& p, const R3::Vector& N) {
  const R3::Vector to_light = light.center - p;
  const double d = Length(to_light), divisor = light.ca + light.la * d + light.qa * d * d;
  return std::max(0.0, Dot(N, to_light) / d) * (divisor > 0 ? light.power / divisor : light.power);
}

// A square of side by side point lights, one unit apart.
std::vector<LightBound> Ceiling(int side) {
  std::vector<LightBound> lights;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) lights.push_back({.center = {i + 0.5, 0, j + 0.5}, .power = 1});
  return lights;
}

struct Variances {
  double by_tree = 0, uniform = 0;
};

// The exact variance of value / probability of one light, summed over random points below the ceiling.
Variances BelowTheCeiling(int side, double height) {
  const auto lights = Ceiling(side);
  const LightTree tree(lights);
  const int count = side * side;
  Numbers numbers(1);
  Variances variances;
  for (int k = 0; k < 30; ++k) {
    const double x = numbers(0, side), z = numbers(0, side);
    const R3::Point p{x, -height, z};
    double all = 0, square_by_tree = 0, square_uniform = 0;
    for (int i = 0; i < count; ++i) {
      const double value = Irradiance(lights[static_cast<std::size_t>(i)], p, {0, 1, 0});
      all += value;
      square_by_tree += value * value / tree.Probability(p, {0, 1, 0}, i);
      square_uniform += value * value * count;
    }
    variances.by_tree += square_by_tree - all * all;
    variances.uniform += square_uniform - all * all;
  }
  return variances;
}

TEST(LightTree, BeatsUniformChoiceUnderACeilingOfLights) {
  for (const int side : {8, 32})
    for (const double height : {0.5, 2.0, 8.0}) {
      const Variances variances = BelowTheCeiling(side, height);
      const double gain = variances.uniform / variances.by_tree;
      EXPECT_GT(gain, 3.5 * 3.5) << side * side << " lights " << height << " above";
      const std::string name = std::to_string(side * side) + "_lights_" + std::to_string(static_cast<int>(10 * height));
      RecordProperty("variance_ratio_" + name + "_tenths_above", std::to_string(gain));
    }
}

TEST(LightTree, GrazingLightsKeepATenthOfTheirImportance) {
  // Two equal lights at the same distance, one overhead and one at the horizon.
  const LightTree tree({{.center = {0, 1, 0}, .power = 1}, {.center = {1, 1e-9, 0}, .power = 1}});
  EXPECT_NEAR(tree.Probability({}, {0, 1, 0}, 1), 0.1 / 1.1, 1e-9);
}

TEST(LightTree, ValueOverProbabilityIsRightOnAverage) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto lights = RandomLights(200, seed);
    const LightTree tree(lights);
    Numbers numbers(50 + seed);
    const R3::Point p = RandomPoint(numbers);
    const R3::Vector N = RandomUnit(numbers);
    double truth = 0, by_probability = 0;
    for (int i = 0; i < 200; ++i) {
      const LightBound& light = lights[static_cast<std::size_t>(i)];
      if (light.is_infinite) continue;
      const double value = Irradiance(light, p, N), probability = tree.Probability(p, N, i);
      truth += value;
      if (probability > 0) by_probability += probability * (value / probability);
    }
    EXPECT_NEAR(by_probability, truth, 1e-12 * truth);

    double sum = 0, squares = 0;
    constexpr int draws = 100'000;
    for (int i = 0; i < draws; ++i) {
      const auto choice = tree.Choose(p, N, numbers());
      const LightBound& light = lights[static_cast<std::size_t>(choice->light)];
      const double estimate = light.is_infinite ? 0 : Irradiance(light, p, N) / choice->probability;
      sum += estimate, squares += estimate * estimate;
    }
    const double mean = sum / draws, error = std::sqrt((squares / draws - mean * mean) / draws);
    EXPECT_NEAR(mean, truth, 4.5 * error) << seed;
  }
}

TEST(LightTree, NothingIsChosenWhereNoLightCanShine) {
  EXPECT_FALSE(LightTree({}).Choose({}, {0, 1, 0}, 0.5));
  EXPECT_FALSE(LightTree({{.center = {0, 1, 0}}}).Choose({}, {0, 1, 0}, 0.5));  // no power
  const LightTree below(Ceiling(20));
  EXPECT_FALSE(below.Choose({3, 1, 3}, {0, 1, 0}, 0.5));
  EXPECT_EQ(below.Probability({3, 1, 3}, {0, 1, 0}, 7), 0);
  EXPECT_FALSE(below.Choose({3, 0, 3}, {0, 1, 0}, 0.5));  // from the ceiling itself
  EXPECT_TRUE(below.Choose({3, 0, 3}, Unit(R3::Vector{0.01, 1, 0}), 0.5));
}

TEST(LightTree, AgreesWithEachLightInTheTangentPlane) {
  // In a tilted plane far from the origin each light is in front of it or behind it by rounding.
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Numbers numbers(seed);
    const R3::Vector N = RandomUnit(numbers);
    const R3::Tangents tangents = R3::TangentsOf(N);
    const R3::Point middle = R3::Point{} + std::exp(numbers(-10, 20)) * RandomUnit(numbers);
    std::vector<LightBound> lights;
    for (int i = 0; i < 300; ++i) {
      const double a = numbers(-1, 1), b = numbers(-1, 1);
      lights.push_back({.center = middle + (a * tangents.first + b * tangents.second), .power = 1});
    }
    const LightTree tree(lights);
    const R3::Point p = middle + 0.3 * tangents.first;
    bool can_be_lit = false;
    for (int i = 0; i < 300; ++i) {
      const bool counts = !IsBehind(lights[static_cast<std::size_t>(i)], p, N);
      ASSERT_EQ(tree.Probability(p, N, i) > 0, counts);
      can_be_lit |= counts;
    }
    EXPECT_NEAR(Sum(tree, 300, p, N), can_be_lit ? 1 : 0, 1e-12);
  }
}

TEST(LightTree, InfiniteLightsShareByPowerWithWhatArrivesFromOthers) {
  const LightTree tree({{.center = {0, 2, 0}, .power = 8},  // 8 / 2^2
                        {.power = 1, .is_infinite = true},
                        {.power = 5, .is_infinite = true},
                        {.power = 0, .is_infinite = true}});
  EXPECT_NEAR(tree.Probability({}, {0, 1, 0}, 0), 0.25, 1e-15);
  EXPECT_NEAR(tree.Probability({}, {0, 1, 0}, 1), 0.125, 1e-15);
  EXPECT_NEAR(tree.Probability({}, {0, 1, 0}, 2), 0.625, 1e-15);
  EXPECT_EQ(tree.Probability({}, {0, 1, 0}, 3), 0);
  EXPECT_NEAR(tree.Probability({}, {0, -1, 0}, 2), 5.0 / 6, 1e-15);
}

TEST(LightTree, WithoutAttenuationOnlyPowerCounts) {
  const LightTree tree({{.center = {0, 1, 0}, .power = 1, .qa = 0}, {.center = {0, 100, 0}, .power = 3, .qa = 0}});
  EXPECT_NEAR(tree.Probability({}, {0, 1, 0}, 1), 0.75, 1e-15);
}

/// Returns the lights with lengths in a unit that is that many times smaller: light that falls off with the squared
/// distance, as from an area, sends its power through a correspondingly larger area.
std::vector<LightBound> InOtherUnit(std::vector<LightBound> lights, double scale) {
  for (LightBound& light : lights) {
    light.center = R3::Point{} + scale * FromOrigin(light.center);
    light.radius *= scale;
    if (light.ca == 0 && light.la == 0 && light.qa > 0 && !light.is_infinite) {
      light.power *= scale * scale;
    } else {
      light.la /= scale;
      light.qa /= scale * scale;
    }
  }
  return lights;
}

TEST(LightTree, TheUnitOfLengthChangesNoChoice) {
  for (const int count : {3, 20, 300})
    for (const double scale : {0x1p-10, 0.3, 8.0, 1000.0, 0x1p20}) {
      const bool is_exact = std::exp2(std::round(std::log2(scale))) == scale;
      const auto lights = RandomLights(count, 4);
      const LightTree tree(lights), other(InOtherUnit(lights, scale));
      Numbers numbers(5);
      for (int k = 0; k < 20; ++k) {
        const R3::Point p = RandomPoint(numbers), q = R3::Point{} + scale * FromOrigin(p);
        const R3::Vector N = RandomUnit(numbers);
        for (int i = 0; i < count; ++i) {
          const double one = tree.Probability(p, N, i), same = other.Probability(q, N, i);
          if (is_exact) {
            ASSERT_EQ(same, one) << count << " lights, times " << scale;
          } else {
            ASSERT_NEAR(same, one, 1e-12) << count << " lights, times " << scale;
          }
        }
      }
    }
}

TEST(LightTree, LightsWithoutAttenuationIgnoreDistanceAmongOthers) {
  for (const double distance : {0.1, 1.0, 1e3, 1e9}) {
    std::vector<LightBound> lights{{.center = {0, distance, 0}, .power = 6, .ca = 2, .qa = 0},
                                   {.power = 1, .is_infinite = true}};
    for (int i = 0; i < 40; ++i) lights.push_back({.center = {i * 0.1, distance, 1}, .power = 9, .qa = 1.0 + i % 20});
    const LightTree tree(lights);
    const double without = tree.Probability({}, {0, 1, 0}, 0), infinite = tree.Probability({}, {0, 1, 0}, 1);
    EXPECT_NEAR(without / infinite, 3, 1e-12) << distance;
  }
}

TEST(LightTree, SecondMomentIsBoundedByTheLeastCosine) {
  // Importances I and contributions c have I cos <= c <= I, where cos is the least cosine of an infinite light and all
  // others count with theirs. So the second moment of c / probability, sum I * sum c^2 / I, is at most
  // (sum c)^2 / cos.
  constexpr double least_cosine = 0.5;
  const R3::Vector N{0, 1, 0};
  Numbers numbers(6);
  for (int k = 0; k < 1000; ++k) {
    const double scale = std::exp(numbers(-20, 20));
    const auto above = [&] {
      const R3::Vector to_light{numbers(-1, 1), numbers(1, 3), numbers(-1, 1)};  // a cosine of at least 1 / sqrt(3)
      return R3::Point{} + to_light;
    };
    const auto power = [&] { return std::exp(numbers(-2, 2)); };
    const auto lights = InOtherUnit({{.center = above(), .power = power(), .ca = 1, .qa = 0},
                                     {.center = above(), .power = power()},
                                     {.center = above(), .power = power(), .la = 2, .qa = 0},
                                     {.center = above(), .power = power(), .ca = 1, .la = 0.5, .qa = 0.1},
                                     {.power = power(), .is_infinite = true}},
                                    scale);
    const double infinite_cosine = numbers(least_cosine, 1);
    const LightTree tree(lights);
    double sum = 0, second_moment = 0;
    for (int i = 0; i < 5; ++i) {
      const LightBound& light = lights[static_cast<std::size_t>(i)];
      const double c = light.is_infinite ? infinite_cosine * light.power : Irradiance(light, {}, N);
      sum += c;
      second_moment += c * c / tree.Probability({}, N, i);
    }
    ASSERT_LE(second_moment, sum * sum / least_cosine) << "unit " << scale;
  }
}

TEST(LightTree, HugeTinyAndCoincidentPlacesAndPowersKeepProbabilitiesWhole) {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const double sizes[] = {0, least, 1e-200, 1e-20, 1, 1e20, 1e200, most};
  for (const double power : {least, 1e-200, 1.0, 1e200, most}) {
    std::vector<LightBound> lights;
    for (const double a : sizes)
      for (const double b : sizes) {
        lights.push_back({.center = {a, b, -a}, .power = power});
        lights.push_back({.center = {-a, b, b}, .radius = b, .power = 1, .la = 1});
        lights.push_back({.center = {a, b, -a}, .power = power, .ca = most, .la = most, .qa = most});
      }
    lights.push_back({.power = power, .is_infinite = true});
    lights.push_back({.power = 1, .is_infinite = true});
    const LightTree tree(lights);
    const int count = static_cast<int>(lights.size());
    for (const double x : sizes)
      for (const R3::Vector& N : {R3::Vector{0, 1, 0}, Unit(R3::Vector{1, 2, 3}), R3::Vector{-1, 0, 0}}) {
        const R3::Point p{x, -x, 0};
        ASSERT_NEAR(Sum(tree, count, p, N), 1, 1e-12) << power << " " << x;
        for (const double u : {0.0, 0.3, 0.9, last}) {
          const auto choice = tree.Choose(p, N, u);
          ASSERT_TRUE(choice);
          ASSERT_GT(choice->probability, 0);
          ASSERT_LE(choice->probability, 1);
        }
      }
  }
  std::vector<LightBound> at_one_place(5000, {.center = {1, 2, 3}, .power = 2});
  const LightTree tree(at_one_place);
  for (const R3::Point& p : {R3::Point{}, R3::Point{1, 2, 2.5}})
    for (int i = 0; i < 5000; i += 99) EXPECT_NEAR(tree.Probability(p, {0, 0, 1}, i), 1.0 / 5000, 1e-4);
}

TEST(LightTree, WeakLightsNextToStrongOnesAreStillChosen) {
  const LightTree tree({{.center = {0, 1, 0}, .power = 1e300}, {.center = {0, 1e9, 0}, .power = 1e-300}});
  EXPECT_GT(tree.Probability({}, {0, 1, 0}, 1), 1e-8);
}

// Radiance times area may exceed the range of doubles.
TEST(LightTree, E11_LightsOfInfinitePowerAreChosenLikeTheStrongest) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const LightBound strong{.center = {0, 1, 0}, .power = infinite}, weak{.center = {0, 1, 1}, .power = 1};
  const LightTree tree({strong, weak, strong});
  for (const double u : {0.1, 0.4, 0.6, 0.9}) {
    const auto choice = tree.Choose({0, 0, 0}, {0, 1, 0}, u);
    ASSERT_TRUE(choice);
    EXPECT_NE(choice->light, 1);
    EXPECT_GT(choice->probability, 0.4);
  }
}

}  // namespace

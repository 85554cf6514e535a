#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "source/sample/Random.h"
#include "source/scene/Light.h"

namespace ray {
namespace {

std::unique_ptr<const Light> Make(const std::string& name, const std::vector<double>& arguments) {
  return FindLightKind(name)->make(arguments);
}

// Directions are normalized, so they have all 16 digits although the author wrote three.
TEST(Lights, AreDescribedInFewDigits) {
  EXPECT_EQ(Make("dir_light", {1, 1, 1, 1, 2, 3})->Describe(),
            "directional light along 0.26726 0.53452 0.80178, color 1 1 1");
}

TEST(Lights, EveryKindHasAnExampleThatFitsItsArguments) {
  EXPECT_EQ(LightKinds().size(), 5u);
  for (const LightKind* kind : LightKinds()) {
    ASSERT_EQ(kind->example.size(), kind->arguments.size()) << kind->name;
    const auto light = kind->make(kind->example);
    EXPECT_FALSE(light->IsBlack()) << kind->name;
    EXPECT_TRUE(light->Illuminate({0.5, -2, -1}, {0.3, 0.6})) << kind->name;
    EXPECT_FALSE(light->Describe().empty());
    EXPECT_EQ(FindLightKind(kind->name), kind);
  }
  EXPECT_EQ(FindLightKind("sun"), nullptr);
}

TEST(Lights, ABlackOneOfEveryKindKnowsThatItIs) {
  for (const LightKind* kind : LightKinds()) {
    std::vector<double> black = kind->example;
    black[0] = black[1] = black[2] = 0;
    EXPECT_TRUE(kind->make(black)->IsBlack()) << kind->name;
  }
}

TEST(Lights, WhatArrivesIsFiniteFromFarAndNear) {
  for (const LightKind* kind : LightKinds()) {
    const auto light = kind->make(kind->example);
    for (const double y : {2.999999999, 2.9, 0.0, -1e6, -1e12, -1e150}) {
      const auto arriving = light->Illuminate({0.5, y, -1}, {0.25, 0.75});
      if (!arriving) continue;
      EXPECT_TRUE(std::isfinite(arriving->irradiance.r) && arriving->irradiance.r >= 0) << kind->name << y;
      EXPECT_TRUE(std::isfinite(Length(arriving->to_light))) << kind->name << y;
    }
  }
}

/// Returns true if any of many points on the light gives light to p.
bool Shines(const Light& light, const R3::Point& p) {
  const RandomKey key(11);
  for (std::uint64_t i = 0; i < 64; ++i) {
    const auto sample = light.Illuminate(p, {key.Child(i).Number(), key.Child(i).Child(1).Number()});
    if (sample && !IsBlack(sample->irradiance)) return true;
  }
  return false;
}

// Points around the light, most of them close to the plane of its disc or the surface of its sphere.
TEST(Lights, NeverShineWhereTheyReportThatTheyDoNot) {
  const RandomKey key(7);
  int dark = 0, lit = 0;
  for (const char* kind : {"area_light", "sphere_light"})
    for (std::uint64_t i = 0; i < 20'000; ++i) {
      std::uint64_t next = 0;
      const auto number = [&] { return 2 * key.Child(i).Child(next++).Number() - 1; };
      const double size = std::exp2(60 * number()), radius = size * std::exp2(20 * number());
      const R3::Point center{size * number(), size * number(), size * number()};
      const R3::Vector direction{number(), number(), number()}, aside{number(), number(), number()};
      const bool is_sphere = std::string(kind) == "sphere_light";
      const auto light = is_sphere ? Make(kind, {1, 1, 1, center.x, center.y, center.z, radius, 1, 0, 0})
                                   : Make(kind, {1, 1, 1, center.x, center.y, center.z, direction.x, direction.y,
                                                 direction.z, radius, 1, 0, 0});
      const R3::Vector in_plane = Cross(Unit(direction), aside);
      const double off = std::exp2(-30 + 30 * number()) * (i % 2 ? 1 : -1);
      const R3::Point p = is_sphere ? center + (1 + off) * radius * Unit(aside)
                                    : center + 3 * radius * (in_plane + off * Unit(direction));
      if (light->MayShineOn(p))
        ++lit;
      else
        EXPECT_FALSE(Shines(*light, p)) << kind << " " << i;
      dark += !light->MayShineOn(p);
    }
  EXPECT_GT(dark, 15'000);
  EXPECT_GT(lit, 15'000);
}

TEST(Lights, BatchedSamplesEqualSingleOnesBitForBit) {
  const RandomKey key(5);
  for (const LightKind* kind : LightKinds()) {
    const auto light = kind->make(kind->example);
    for (const double y : {3.0, 2.9, 0.0, -1e6, -1e150, -1e200, 1e160}) {
      LightSamples samples;
      samples.count = 61;  // not a multiple of a vector's length
      for (std::uint32_t i = 0; i < samples.count; ++i) {
        samples.random.Set(i, {key.Child(i).Number(), key.Child(i).Child(1).Number()});
        samples.from.Set(i, {i % 2 == 0 ? 0.5 + i : 0.5, y, -1});
      }
      samples.random.Set(7, {0.5, 0.5});  // the center of a disc
      light->IlluminateEach(samples);
      for (std::uint32_t i = 0; i < samples.count; ++i) {
        const auto alone = light->Illuminate(samples.from[i], samples.random[i]);
        EXPECT_EQ(samples.color[i], alone ? alone->irradiance : R2::Color{}) << kind->name << " at " << y;
        if (!alone) continue;
        EXPECT_EQ(samples.to_light[i], alone->to_light) << kind->name << " at " << y;
      }
    }
  }
}

TEST(Lights, TheDefaultsAreTheCourses) {
  const auto lights = DefaultLights();
  ASSERT_EQ(lights.size(), 2u);
  const auto first = lights[0]->Illuminate({}, {}), second = lights[1]->Illuminate({}, {});
  EXPECT_EQ(first->irradiance, (R2::Color{1, 1, 1}));
  EXPECT_NEAR(first->to_light.x, 3 / std::sqrt(50.0), 1e-15);
  EXPECT_NEAR(first->to_light.z, 5 / std::sqrt(50.0), 1e-15);
  EXPECT_EQ(second->irradiance, (R2::Color{0.5, 0.5, 0.5}));
  EXPECT_NEAR(second->to_light.y, -2 / std::sqrt(22.0), 1e-15);
}

TEST(DirLight, IsTheSameEverywhereAndHasNoPosition) {
  const auto light = Make("dir_light", {1, 2, 3, 0, 0, -10});
  for (const R3::Point& p : {R3::Point{}, R3::Point{1e9, -5, 2}}) {
    const auto arriving = light->Illuminate(p, {});
    EXPECT_EQ(arriving->irradiance, (R2::Color{1, 2, 3}));
    EXPECT_EQ(arriving->to_light, (R3::Vector{0, 0, 1}));
    EXPECT_TRUE(arriving->is_infinite);
  }
}

TEST(PointLight, FadesByItsThreeNumbers) {
  const auto light = Make("point_light", {1, 1, 1, 0, 0, 0, 2, 3, 5});
  EXPECT_DOUBLE_EQ(light->Illuminate({3, 0, 4}, {})->irradiance.r, 1.0 / (2 + 3 * 5 + 5 * 25));
  EXPECT_EQ(light->Illuminate({3, 0, 4}, {})->to_light, (R3::Vector{-3, 0, -4}));
}

TEST(Extremes, E4_APointWhereTheLightIsGetsNothingFromIt) {
  EXPECT_FALSE(Make("point_light", {1, 1, 1, 1, 2, 3, 0, 0, 1})->Illuminate({1, 2, 3}, {}));
  EXPECT_FALSE(Make("spot_light", {1, 1, 1, 1, 2, 3, 0, 0, -1, 0, 0, 1, 1, 1})->Illuminate({1, 2, 3}, {}));
  EXPECT_FALSE(Make("area_light", {1, 1, 1, 1, 2, 3, 0, 0, -1, 0, 0, 0, 1})->Illuminate({1, 2, 3}, {}));
}

TEST(SpotLight, FadesWithTheCosineAndEndsAtItsCutOff) {
  const auto light = Make("spot_light", {1, 1, 1, 0, 0, 0, 0, 0, -2, 0, 0, 1, 0.5, 3});
  const auto at = [&](double angle) { return light->Illuminate({2 * std::sin(angle), 0, -2 * std::cos(angle)}, {}); };
  EXPECT_DOUBLE_EQ(at(0)->irradiance.r, 0.25);
  EXPECT_NEAR(at(0.4)->irradiance.r, std::pow(std::cos(0.4), 3) / 4, 1e-15);
  EXPECT_TRUE(at(0.4999));
  EXPECT_FALSE(at(0.5001));
}

TEST(SpotLight, NeverShinesBackwardsHoweverWide) {
  const auto light = Make("spot_light", {1, 1, 1, 0, 0, 0, 0, 0, -1, 1, 0, 0, std::numbers::pi, 0});
  EXPECT_TRUE(light->Illuminate({100, 0, -0.01}, {}));
  EXPECT_FALSE(light->Illuminate({100, 0, 0}, {}));
  EXPECT_FALSE(light->Illuminate({0, 0, 1}, {}));
  EXPECT_THROW(Make("spot_light", {1, 1, 1, 0, 0, 0, 0, 0, -1, 1, 0, 0, 3.2, 0}), R3::ArgumentError);
}

/// Returns the point on the light that a sample chose.
R3::Point Place(const Light& light, const R3::Point& seen_from, const R2::Point& random) {
  return seen_from + light.Illuminate(seen_from, random)->to_light;
}

TEST(AreaLight, SamplesLieOnItsDiscWhicheverWayItFaces) {
  for (const R3::Vector& d : {R3::Vector{0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 2, -3}, {1e-9, 0, -1}}) {
    const auto light = Make("area_light", {1, 1, 1, 1, 2, 3, d.x, d.y, d.z, 0.5, 1, 0, 0});
    const R3::Point seen_from = R3::Point{1, 2, 3} + 4.0 * Unit(d);
    for (double u = 0; u < 1; u += 0.09)
      for (double v = 0; v < 1; v += 0.09) {
        const R3::Vector from_center = Place(*light, seen_from, {u, v}) - R3::Point{1, 2, 3};
        EXPECT_LE(Length(from_center), 0.5 + 1e-14);
        EXPECT_NEAR(Dot(from_center, Unit(d)), 0, 1e-14);
      }
  }
}

TEST(AreaLight, SamplesFallEvenlyByArea) {
  // A grid of n x n even samples: the share within radius r of a unit disc is r^2, and half lies on either side of any
  // line through the center. The discrepancy of the grid along a curve is of the order of 1/n.
  const auto light = Make("area_light", {1, 1, 1, 0, 0, 0, 0, 0, -1, 1, 1, 0, 0});
  constexpr int n = 200;
  int within[4] = {}, right = 0, above = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const R3::Point p = Place(*light, {0, 0, -5}, {(i + 0.5) / n, (j + 0.5) / n});
      for (int k = 0; k < 4; ++k) within[k] += std::hypot(p.x, p.y) <= 0.2 * (k + 1);
      right += p.x > 0;
      above += p.y > p.x;
    }
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(within[k] / double(n * n), 0.04 * (k + 1) * (k + 1), 2.0 / n);
  EXPECT_NEAR(right / double(n * n), 0.5, 2.0 / n);
  EXPECT_NEAR(above / double(n * n), 0.5, 2.0 / n);
}

TEST(AreaLight, ShinesToOneSideWithTheCosine) {
  const auto light = Make("area_light", {1, 1, 1, 0, 0, 0, 0, 0, -1, 0, 0, 0, 1});
  const double angle = 0.7;
  EXPECT_NEAR(light->Illuminate({2 * std::sin(angle), 0, -2 * std::cos(angle)}, {0.5, 0.5})->irradiance.r,
              std::cos(angle) / 4, 1e-15);
  EXPECT_FALSE(light->Illuminate({0, 0, 1}, {0.5, 0.5}));
  EXPECT_FALSE(light->Illuminate({1, 0, 0}, {0.5, 0.5}));
}

TEST(Extremes, E6_SizelessDiscsArePointsAndEdgeOnOnesDark) {
  const auto point = Make("area_light", {1, 1, 1, 0, 0, 0, 0, 0, -1, 0, 1, 0, 0});
  EXPECT_FALSE(point->IsExtended());
  EXPECT_EQ(Place(*point, {0, 0, -2}, {0.9, 0.1}), (R3::Point{0, 0, 0}));
  const auto disc = Make("area_light", {1, 1, 1, 0, 0, 0, 0, 0, -1, 1, 1, 0, 0});
  EXPECT_TRUE(disc->IsExtended());
  EXPECT_FALSE(disc->Illuminate({3, 0, 0}, {0.9, 0.1}));
}

TEST(Lights, ErrorsPointAtAZeroDirection) {
  const auto index = [](const std::string& name, const std::vector<double>& arguments) {
    try {
      Make(name, arguments);
      return -1;
    } catch (const R3::ArgumentError& error) {
      return static_cast<int>(error.index);
    }
  };
  EXPECT_EQ(index("dir_light", {1, 1, 1, 0, 0, 0}), 3);
  EXPECT_EQ(index("spot_light", {1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1}), 6);
  EXPECT_EQ(index("area_light", {1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0}), 6);
  EXPECT_EQ(index("spot_light", {1, 1, 1, 0, 0, 0, 0, 0, -1, 1, 0, 0, 4, 1}), 12);
}

}  // namespace
}  // namespace ray

#include "source/integrate/ShadingPoint.h"
#include "tests/Named.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/Project.h"

namespace ray {
namespace {

TEST(FresnelReflectance, AtRightAnglesIsTheSquareOfTheDifferenceOverTheSum) {
  for (const double n : {1e-6, 0.5, 1 / 1.5, 1.0, 1.33, 1.5, 2.4, 1e6}) {
    const double amplitude = (1 - n) / (1 + n);
    EXPECT_NEAR(FresnelReflectance(1, 1 / n), amplitude * amplitude, 1e-14) << n;
    EXPECT_NEAR(FresnelReflectance(1, n), amplitude * amplitude, 1e-14) << n;
  }
}

TEST(Extremes, F9_GrazingLightIsAllReflected) {
  for (const double n : {0.1, 0.7, 1.000001, 1.5, 100.0}) {
    EXPECT_NEAR(FresnelReflectance(0, 1 / n), 1, 1e-12) << n;
    EXPECT_NEAR(FresnelReflectance(1e-300, 1 / n), 1, 1e-12) << n;
  }
}

// At Brewster's angle, whose tangent is n, light polarised along the plane is not reflected at all; what is left is
// half of that across it: ((1 - n^2) / (1 + n^2))^2 / 2.
TEST(FresnelReflectance, AtBrewstersAngleIsOfOnePolarisationAlone) {
  for (const double n : {0.9, 1.33, 1.5, 2.4}) {
    const double across = (1 - n * n) / (1 + n * n);
    EXPECT_NEAR(FresnelReflectance(std::cos(std::atan(n)), 1 / n), across * across / 2, 1e-14) << n;
  }
}

TEST(Extremes, F4_BeyondTheCriticalAngleEverythingIsReflectedAndBeforeItNothingJumps) {
  const double n = 1.5, critical = std::sqrt(1 - 1 / (n * n));  // its cosine
  for (double cosine = 0; cosine < critical; cosine += 0.01) EXPECT_EQ(FresnelReflectance(cosine, n), 1) << cosine;
  double cosine = critical;
  for (int i = 0; i < 8; ++i) cosine = std::nextafter(cosine, 0.0);
  for (int i = 0; i < 16; ++i, cosine = std::nextafter(cosine, 1.0)) {
    const double share = FresnelReflectance(cosine, n);
    EXPECT_LE(share, 1);
    EXPECT_NEAR(share, 1, 1e-6);
  }
}

TEST(FresnelReflectance, IsASmoothShareAndTheSameFromBothSides) {
  for (const double n : {1.1, 1.5, 3.0}) {
    double last = 1;
    for (double cosine = 0; cosine <= 1; cosine += 0.001) {
      const double share = FresnelReflectance(cosine, 1 / n);
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      if (n <= 1.5 && cosine < 0.5) {
        EXPECT_LE(share, last) << "it falls from grazing on";
      }
      last = share;
      // Light that comes the same way back is split the same: Stokes' relation.
      const double sine_behind = std::sqrt(1 - cosine * cosine) / n;
      EXPECT_NEAR(FresnelReflectance(std::sqrt(1 - sine_behind * sine_behind), n), share, 1e-9) << n << ' ' << cosine;
    }
  }
}

ShadingPoint Seen(const project::Stage& stage, const R3::Ray& ray) {
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  const auto hit = accelerator->Intersect(ray, workspace);
  EXPECT_TRUE(hit);
  return ShadingPointAt(stage.world, {.ray = ray, .index = {}}, *hit);
}

TEST(SpecularWeights, SplitWhatIsClearByFresnelAndKeepItsSum) {
  const project::Stage stage(
      project::FromText("material 0 0 0  0 0 0  0.1 0.2 0.3  0.8 0.7 0.6  0 0 0  10 1.5 0 sphere 0  0 0 0  1"));
  for (const double aside : {0.0, 0.5, 0.9, 0.999}) {
    const ShadingPoint s = Seen(stage, {{aside, 0, 5}, {0, 0, -1}});
    const SpecularWeights plain = SpecularWeightsOf(s, false), split = SpecularWeightsOf(s, true);
    EXPECT_EQ(plain.reflected, s.material->ks);
    EXPECT_EQ(plain.transmitted, s.material->kt);
    const double share = FresnelReflectance(std::sqrt(1 - aside * aside), 1 / 1.5);
    EXPECT_NEAR(split.reflected.r, 0.1 + share * 0.8, 1e-12);
    EXPECT_NEAR(split.reflected.g + split.transmitted.g, 0.9, 1e-15);
    EXPECT_NEAR(split.transmitted.b, (1 - share) * 0.6, 1e-12);
  }
}

TEST(Absorption, ThroughABallAlongItsDiameterIsTheExponentialOfIt) {
  for (const double radius : {0.5, 1.0, 3.0}) {
    const project::Stage stage(
        project::FromText("background 1 1 1 camera 0 0 9  0 0 -1  0 1 0  1e-8  0.01 100 "
                          "point_light 0 0 0  0 9 0  1 0 0 "
                          "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 1.5 0 "
                          "absorb 0  0.1 0.5 2 sphere 0  0 0 0  " +
                          std::to_string(radius)));
    for (const char* mode : {"whitted", "path"}) {
      RenderSettings settings;
      settings.width = settings.height = 1;
      settings.mode = project::Named{mode};
      settings.trace.min_luminance = 0;
      settings.trace.roulette = Roulette::off;
      const R2::Color seen = project::Render(stage, settings).image.At(0, 0);
      EXPECT_NEAR(seen.r, std::exp(-0.1 * 2 * radius), 1e-7) << mode;
      EXPECT_NEAR(seen.g, std::exp(-0.5 * 2 * radius), 1e-7) << mode;
      EXPECT_NEAR(seen.b, std::exp(-2 * 2 * radius), 1e-7) << mode;
    }
  }
}

TEST(Absorption, IsOfTheInsideAloneHoweverLongTheDirection) {
  const project::Stage stage(
      project::FromText("material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 1 0 absorb 0  1 1 1 "
                        "sphere 0  0 0 0  1"));
  const ShadingPoint outside = Seen(stage, {{0, 0, 5}, {0, 0, -0.25}});
  EXPECT_TRUE(outside.entering);
  EXPECT_EQ(outside.path.throughput, (R2::Color{1, 1, 1}));
  for (const double length : {0.25, 1.0, 1e3}) {
    const ShadingPoint inside = Seen(stage, {{0, 0, 0.5}, {0, 0, -length}});
    EXPECT_FALSE(inside.entering);
    EXPECT_NEAR(inside.path.throughput.g, std::exp(-1.5), 1e-14) << length;
  }
}

}  // namespace
}  // namespace ray

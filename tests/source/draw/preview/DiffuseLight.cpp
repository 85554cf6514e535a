#include "source/draw/preview/DiffuseLight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

/// A smooth sky of 64 x 32: brighter upward, red to the right.
ray::Environment Sky() {
  R2::Image image(64, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) image.Set(x, y, {1 + std::sin(2 * std::numbers::pi * x / 64), 0.05 * y, 1});
  return ray::Environment(image);
}

TEST(DiffuseLight, OfTheSameLightFromEverywhereIsThatLight) {
  const ray::DiffuseLight light = ray::DiffuseLightOf(R2::Color{0.25, 0.5, 2});
  EXPECT_EQ(light.At({0, 0.6, 0.8}), (R2::Color{0.25, 0.5, 2}));
}

// Oracle: the environment's own samples, the cosine with which they arrive, over pi.
TEST(DiffuseLight, MatchesScatteredEnvironmentLightWithinThreePercent) {
  const ray::Environment sky = Sky();
  const ray::DiffuseLight light = ray::DiffuseLightOf(sky);
  for (const R3::Vector& N :
       {R3::Vector{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0.6, -0.8}, {0.6, 0.64, 0.48}}) {
    R2::Color sum;
    constexpr int count = 256;
    for (int i = 0; i < count * count; ++i) {
      const auto drawn = sky.Draw({(i % count + 0.5) / count, (i / count + 0.5) / count});
      sum += std::max(0.0, Dot(N, drawn.direction)) / (drawn.pdf * std::numbers::pi * count * count) * drawn.radiance;
    }
    const R2::Color found = light.At(N);
    EXPECT_NEAR(found.r, sum.r, 0.03 * sum.r);
    EXPECT_NEAR(found.g, sum.g, 0.03 * sum.g);
    EXPECT_NEAR(found.b, sum.b, 0.03 * sum.b);
  }
}

TEST(Shrunk, KeepsBlockMeansAndLeavesSmallImagesAlone) {
  R2::Image image(5, 2);
  for (int x = 0; x < 5; ++x) image.Set(x, 1, {1.0 * x, 0, 0});
  EXPECT_EQ(ray::Shrunk(image, 5, 2), image);
  const R2::Image shrunk = ray::Shrunk(image, 2, 1);
  ASSERT_EQ(shrunk.Width(), 2);
  EXPECT_NEAR(shrunk.At(0, 0).r, 0.25, 1e-6);
  EXPECT_NEAR(shrunk.At(1, 0).r, 1.5, 1e-6);
}

}  // namespace

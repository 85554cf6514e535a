#include "source/scene/Texture.h"

#include <gtest/gtest.h>

namespace {

ray::Texture TwoByTwo() {
  R2::Image image(2, 2);
  image.Set(0, 0, {1, 0, 0});
  image.Set(1, 0, {0, 1, 0});
  image.Set(0, 1, {0, 0, 1});
  image.Set(1, 1, {1, 1, 1});
  return {image};
}

TEST(Texture, ShowsEachTexelPureAtItsCenter) {
  const ray::Texture texture = TwoByTwo();
  EXPECT_EQ(texture.At({0.25, 0.25}), (R2::Color{1, 0, 0}));
  EXPECT_EQ(texture.At({0.75, 0.25}), (R2::Color{0, 1, 0}));
  EXPECT_EQ(texture.At({0.25, 0.75}), (R2::Color{0, 0, 1}));
  EXPECT_EQ(texture.At({0.75, 0.75}), (R2::Color{1, 1, 1}));
}

TEST(Texture, BlendsBetweenCentersAndAcrossTheSeam) {
  const ray::Texture texture = TwoByTwo();
  EXPECT_EQ(texture.At({0.5, 0.25}), (R2::Color{0.5, 0.5, 0}));
  EXPECT_EQ(texture.At({0, 0.25}), (R2::Color{0.5, 0.5, 0}));
  EXPECT_EQ(texture.At({0.5, 0.5}), (R2::Color{0.5, 0.5, 0.5}));
}

TEST(Texture, RepeatsBeyondTheUnitSquareAndStaysInsideTheImageAtAnyCoordinate) {
  const ray::Texture texture = TwoByTwo();
  EXPECT_EQ(texture.At({3.25, -1.75}), texture.At({0.25, 0.25}));
  for (const double far : {1e9, -1e9, 1e300, -1e-300, -0.0, 1.0, -1e-17}) {
    const R2::Color c = texture.At({far, -far});
    EXPECT_TRUE(c.r >= 0 && c.r <= 1) << far;
  }
}

}  // namespace

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

// A ray never meets a center exactly.
TEST(Texture, ShowsATexelPureDespiteRoundedCoordinates) {
  for (const int columns : {2, 3, 16, 1000}) {
    R2::Image image(columns, 1);
    for (int x = 1; x < columns; x += 2) image.Set(x, 0, {1, 1, 1});
    const ray::Texture texture{image};
    for (const R3::VEnds ends : {R3::VEnds{}, R3::VEnds{R3::VEnd::rim, R3::VEnd::rim}})
      for (int x = 0; x < columns; ++x)
        for (const double off : {-0x1p-51, -0x1p-53, 0.0, 0x1p-53, 0x1p-51})
          EXPECT_EQ(texture.At({(x + 0.5) / columns + off, 0.5}, ends), image.At(x, 0)) << columns << " " << x;
  }
}

TEST(Texture, BlendsBetweenCentersAndAcrossTheSeam) {
  const ray::Texture texture = TwoByTwo();
  EXPECT_EQ(texture.At({0.5, 0.25}), (R2::Color{0.5, 0.5, 0}));
  EXPECT_EQ(texture.At({0, 0.25}), (R2::Color{0.5, 0.5, 0}));
  EXPECT_EQ(texture.At({0.5, 0.5}), (R2::Color{0.5, 0.5, 0.5}));
}

TEST(Texture, RepeatsAndStaysInsideTheImageAtAnyCoordinate) {
  const ray::Texture texture = TwoByTwo();
  EXPECT_EQ(texture.At({3.25, -1.75}), texture.At({0.25, 0.25}));
  for (const double far : {1e9, -1e9, 1e300, -1e-300, -0.0, 1.0, -1e-17}) {
    const R2::Color c = texture.At({far, -far});
    EXPECT_TRUE(c.r >= 0 && c.r <= 1) << far;
  }
}

// Half a turn from column 0 of three is the middle between columns 1 and 2.
TEST(Texture, ContinuesBeyondAPoleHalfATurnFurther) {
  R2::Image image(3, 2);
  for (int x = 0; x < 3; ++x) image.Set(x, 0, {1, 1, 1}), image.Set(x, 1, {0.25 * x, 0, 0});
  const ray::Texture texture{image};
  const R3::VEnds ends{R3::VEnd::pole, R3::VEnd::pole};
  EXPECT_EQ(texture.At({0.5 / 3, 1}, ends), (R2::Color{(0 + 0.375) / 2, 0, 0}));
  EXPECT_EQ(texture.At({0.5 / 3, 1.25}, ends), (R2::Color{0.375, 0, 0}));
  EXPECT_EQ(texture.At({0.5 / 3, 0}, ends), (R2::Color{1, 1, 1}));
  EXPECT_EQ(texture.At({0.5 / 3, 0.75}, ends), texture.At({0.5 / 3, 0.75}));
}

TEST(Texture, BeyondARimTheLastRowContinues) {
  const ray::Texture texture = TwoByTwo();
  const R3::VEnds ends{R3::VEnd::rim, R3::VEnd::rim};
  for (const double v : {0.75, 0.9, 1.0, 1.25}) EXPECT_EQ(texture.At({0.25, v}, ends), (R2::Color{0, 0, 1})) << v;
  for (const double v : {0.25, 0.1, 0.0, -0.25}) EXPECT_EQ(texture.At({0.25, v}, ends), (R2::Color{1, 0, 0})) << v;
}

// Slopes are evaluated half a row beyond each end.
TEST(Texture, OfASingleTexelIsThatTexelEverywhere) {
  R2::Image image(1, 1);
  image.Set(0, 0, {1, 0.5, 0.25});
  const ray::Texture texture{image};
  for (const auto end : {R3::VEnd::repeated, R3::VEnd::rim, R3::VEnd::pole})
    for (const double v : {-0.5, -0.25, 0.0, 0.5, 1.0, 1.5})
      EXPECT_EQ(texture.At({0.3, v}, {end, end}), (R2::Color{1, 0.5, 0.25})) << v;
}

}  // namespace

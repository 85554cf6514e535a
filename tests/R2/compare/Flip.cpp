#include "R2/compare/Flip.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/R2/Filled.h"

namespace R2 {
namespace {

/// Makes steps of every size in every channel; rows counted from the top, as the figures below were measured.
Image Pattern(int a, int b, int c) {
  Image image(64, 48);
  for (int row = 0; row < 48; ++row)
    for (int x = 0; x < 64; ++x) {
      const auto byte = [&](int p, int q) { return ((x * p + row * q) % 256) / 255.0; };
      image.Set(x, 47 - row, {byte(a, b), byte(b, c), byte(c, a)});
    }
  return image;
}

double FromTop(const Plane& plane, int row, int x) { return plane.Row(plane.height - 1 - row)[x]; }

TEST(Flip, AnImageDoesNotDifferFromItself) {
  const Image image = Pattern(7, 13, 3);
  for (const float value : Flip(image, image).values) EXPECT_EQ(value, 0);
}

// Measured with the authors' own program (flip-evaluator 1.7, its maps averaged in double precision) on the same bytes.
// It computes in single precision, and the square root in the last step turns 1e-8 into 1e-4 where features are equal.
TEST(Flip, AgreesWithTheAuthorsProgram) {
  const Plane near = Flip(Pattern(7, 13, 3), Pattern(7, 12, 4));
  EXPECT_NEAR(Mean(near), 0.5930472, 1e-5);
  EXPECT_NEAR(FromTop(near, 0, 0), 0.018953, 1e-4);
  EXPECT_NEAR(FromTop(near, 5, 7), 0.199904, 1e-4);
  EXPECT_NEAR(FromTop(near, 24, 30), 0.735947, 1e-4);
  const Plane nearer = Flip(Pattern(7, 13, 3), Pattern(7, 12, 4), 20);
  EXPECT_NEAR(Mean(nearer), 0.6082175, 1e-5);
  EXPECT_NEAR(FromTop(nearer, 5, 7), 0.157987, 1e-4);

  const Image black = Filled(50, 40, {});
  EXPECT_NEAR(Mean(Flip(black, Filled(50, 40, {1, 1, 1}))), 0.967386, 1e-5);
  EXPECT_NEAR(Mean(Flip(black, Filled(50, 40, {1, 0, 0}))), 0.970500, 1e-5);
  Image dot = black;
  dot.Set(25, 19, {1, 1, 1});
  EXPECT_NEAR(Mean(Flip(black, dot)), 0.0071546, 1e-5);
  EXPECT_NEAR(FromTop(Flip(black, dot), 20, 26), 0.763491, 1e-4);
}

// The paper scales its differences by that of the two primaries farthest apart.
TEST(Flip, GreenAndBlueDifferByOne) {
  EXPECT_NEAR(Mean(Flip(Filled(9, 9, {0, 1, 0}), Filled(9, 9, {0, 0, 1}))), 1, 1e-6);
}

TEST(Flip, IsTheSameEitherWay) {
  const Image a = Pattern(7, 13, 3), b = Pattern(5, 2, 9);
  EXPECT_EQ(Flip(a, b).values, Flip(b, a).values);
}

TEST(Flip, GrowsWithTheDifference) {
  const Image black = Filled(20, 20, {});
  double last = 0;
  for (int i = 1; i <= 20; ++i) {
    const double flip = Mean(Flip(black, Filled(20, 20, {i / 20.0, i / 20.0, i / 20.0})));
    EXPECT_GT(flip, last) << i;
    last = flip;
  }
}

// A more distant viewer sees less: a checkerboard of single pixels turns gray.
TEST(Flip, FineNoiseVanishesFromAfar) {
  Image checkers(60, 60);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) checkers.Set(x, y, (x + y) % 2 ? Color{0.6, 0.6, 0.6} : Color{0.4, 0.4, 0.4});
  const Image gray = Filled(60, 60, {0.5, 0.5, 0.5});
  EXPECT_GT(Mean(Flip(checkers, gray, 10)), 5 * Mean(Flip(checkers, gray, 200)));
}

TEST(Flip, StaysWithinZeroAndOneForAnyImages) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  Image odd = Pattern(7, 13, 3);
  odd.Set(3, 3, {no_number, infinite, -infinite});
  odd.Set(40, 3, {-5, 1e30, no_number});
  for (const double pixels_per_degree : {1.0, 3.0, 67.0, 1000.0})
    for (const float value : Flip(odd, Filled(64, 48, {0, 0, 1}), pixels_per_degree).values) {
      ASSERT_GE(value, 0);
      ASSERT_LE(value, 1.0001);
    }
  EXPECT_EQ(Flip(Filled(1, 1, {no_number, no_number, no_number}), Filled(1, 1, {})).values[0], 0) << "NaN is black";
}

}  // namespace
}  // namespace R2

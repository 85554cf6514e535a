#include "source/integrate/debug/Heat.h"

#include <gtest/gtest.h>

namespace ray {
namespace {

TEST(Heat, GoesFromBlackOverBlueRedAndYellowToWhiteByPowersOfTen) {
  EXPECT_EQ(HeatColor(0), (R2::Color{0, 0, 0}));
  EXPECT_EQ(HeatColor(1), (R2::Color{0, 0, 0}));
  EXPECT_EQ(HeatColor(10), (R2::Color{0, 0, 1}));
  EXPECT_EQ(HeatColor(100), (R2::Color{1, 0, 0}));
  EXPECT_EQ(HeatColor(1000), (R2::Color{1, 1, 0}));
  EXPECT_EQ(HeatColor(1e4), (R2::Color{1, 1, 1}));
  EXPECT_EQ(HeatColor(1e9), (R2::Color{1, 1, 1}));
}

TEST(Heat, CountsWhatWasLookedAt) { EXPECT_EQ(Heat({.node_visits = 3, .box_tests = 2, .primitive_tests = 4}), 7); }

}  // namespace
}  // namespace ray

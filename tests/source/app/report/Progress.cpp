#include "source/app/report/Progress.h"

#include <gtest/gtest.h>

namespace ray {
namespace {

TEST(Progress, ShowsPercentTimeLeftAndSpeed) {
  EXPECT_EQ(ProgressText({.done = 42, .total = 100, .rays = 30'000'000}, 10), " 42%  0:14 left  3.0 Mrays/s");
  EXPECT_EQ(ProgressText({.done = 0, .total = 7, .rays = 0}, 0), "  0%");
  EXPECT_EQ(ProgressText({.done = 7, .total = 7, .rays = 0}, 1), "100%  0:00 left  0.0 Mrays/s");
}

TEST(Progress, NamesTheWorkAfterTheSamples) {
  EXPECT_EQ(ProgressText({1, 4, 0, RenderPhase::guides}, 2), " 25%  0:06 left  gathering guides");
  EXPECT_EQ(ProgressText({3, 4, 0, RenderPhase::filters}, 3), " 75%  0:01 left  denoising");
}

TEST(Progress, ReachesAHundredOnlyAtTheEnd) {
  EXPECT_TRUE(ProgressText({.done = 999'999, .total = 1'000'000, .rays = 0}, 1).starts_with(" 99%"));
}

TEST(Progress, DurationsReadLikeClocks) {
  EXPECT_EQ(DurationText(0), "0:00");
  EXPECT_EQ(DurationText(6.2), "0:07");
  EXPECT_EQ(DurationText(59.5), "1:00");
  EXPECT_EQ(DurationText(3723), "1:02:03");
  EXPECT_EQ(DurationText(1e300), "ages");
}

TEST(Progress, QuietMeansNone) { EXPECT_EQ(ChooseProgressStyle(true), ProgressStyle::none); }

}  // namespace
}  // namespace ray

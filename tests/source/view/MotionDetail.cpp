#include "source/view/MotionDetail.h"

#include <gtest/gtest.h>

namespace {

using ray::ClipMatrix;
using ray::MotionDetail;

ClipMatrix ViewOf(int number) {
  ClipMatrix view{};
  view[0] = number;
  return view;
}

/// The steps of drawings each 1/100 s after the one before, of views that move, each as slow as `seconds` says of its
/// step.
template <typename Seconds>
std::vector<int> StepsOf(MotionDetail& detail, int count, const Seconds& seconds,
                         const ray::DrawingSize& size = {3840, 2160}) {
  std::vector<int> steps;
  for (int i = 0; i < count; ++i) {
    steps.push_back(detail.StepFor(ViewOf(i), size, 0.01 * i));
    detail.Took(seconds(steps.back()));
  }
  return steps;
}

/// As long as there are pixels.
auto ByPixels(double full) {
  return [full](int step) { return full / (step * step); };
}

TEST(MotionDetail, StaysInFullWhereADrawingIsAsFastAsAScreen) {
  MotionDetail detail;
  EXPECT_EQ(StepsOf(detail, 4, ByPixels(0.008)), (std::vector{1, 1, 1, 1}));
  EXPECT_FALSE(detail.RefinementTime());
  EXPECT_TRUE(detail.IsSmooth());
}

TEST(MotionDetail, TakesTheFewestPixelsLessThatMakeADrawingAsFastAsAScreen) {
  for (const auto& [full, step] : {std::pair{0.017, 2}, {0.06, 2}, {0.07, 3}, {0.15, 3}, {0.16, 4}, {100.0, 9}}) {
    MotionDetail detail;
    EXPECT_EQ(StepsOf(detail, 3, ByPixels(full)), (std::vector{1, step, step})) << full;
  }
}

TEST(MotionDetail, DrawsInFullOnceTheViewRests) {
  MotionDetail detail;
  StepsOf(detail, 3, ByPixels(0.05));
  ASSERT_TRUE(detail.RefinementTime());
  const double due = *detail.RefinementTime();
  EXPECT_EQ(detail.StepFor(ViewOf(2), {3840, 2160}, due - 0.01), 2) << "what is drawn anew meanwhile does not flicker";
  EXPECT_EQ(*detail.RefinementTime(), due);
  EXPECT_EQ(detail.StepFor(ViewOf(2), {3840, 2160}, due), 1);
  EXPECT_FALSE(detail.RefinementTime());
}

TEST(MotionDetail, IsSmoothOnceTheViewRests) {
  MotionDetail detail;
  StepsOf(detail, 4, ByPixels(0.012));
  EXPECT_FALSE(detail.IsSmooth()) << "several samples per pixel would miss frames";
  ASSERT_TRUE(detail.RefinementTime());
  EXPECT_EQ(detail.StepFor(ViewOf(3), {3840, 2160}, *detail.RefinementTime()), 1);
  EXPECT_TRUE(detail.IsSmooth());
  EXPECT_FALSE(detail.RefinementTime());
}

TEST(MotionDetail, ForgetsAFirstDrawingThatWasSlowForOnce) {
  MotionDetail detail;
  int drawn = 0;
  const auto slow_at_first = [&](int step) { return (drawn++ == 0 ? 0.3 : 0.002) / (step * step); };
  EXPECT_EQ(StepsOf(detail, 4, slow_at_first), (std::vector{1, 5, 1, 1}));
}

TEST(MotionDetail, LeavesPixelsEnoughInSmallWindows) {
  for (const auto& [size, step] :
       {std::pair<ray::DrawingSize, int>{{320, 200}, 1}, {{512, 512}, 2}, {{1280, 800}, 3}}) {
    MotionDetail detail;
    EXPECT_EQ(StepsOf(detail, 3, ByPixels(10), size), (std::vector{1, step, step})) << size.width;
  }
}

TEST(MotionDetail, DrawsAViewThatDoesNotMoveInFullHoweverOften) {
  MotionDetail detail;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(detail.StepFor(ViewOf(0), {512, 512}, 0.01 * i), 1);
    detail.Took(1);
  }
}

}  // namespace

#include "source/draw/MotionDetail.h"

#include <gtest/gtest.h>

namespace {

using ray::DrawingDetail;
using ray::MotionDetail;

constexpr ray::DrawingSize large{3840, 2160};

/// Returns a frame of a view that differs from those of other numbers.
ray::FrameState ViewOf(int number, const ray::DrawingSize& size = large) {
  ray::FrameState shown;
  shown.clip_from_drawing[0] = number;
  shown.size = shown.view = size;
  return shown;
}

/// Returns a drawing time that is proportional to the pixels drawn.
auto ByPixels(double full) {
  return [full](const DrawingDetail& detail) { return full / (detail.pixel_step * detail.pixel_step); };
}

/// Draws a view until it has its final detail, and returns that.
template <typename Seconds>
DrawingDetail Rest(MotionDetail& detail, const Seconds& seconds, const ray::FrameState& shown, double now = 0) {
  for (int count = 0;; ++count) {
    const DrawingDetail last = detail.For(shown, now);
    detail.Took(seconds(last));
    EXPECT_LT(count, 9) << "it never ends";
    if (count >= 9 || !detail.RefinementTime()) return last;
    now = std::max(now, *detail.RefinementTime());
  }
}

/// Returns the details of drawings at intervals of 1/100 s, of views that move after a rest; `seconds` returns the time
/// of each.
template <typename Seconds>
std::vector<DrawingDetail> Moving(MotionDetail& detail, int count, const Seconds& seconds,
                                  const ray::DrawingSize& size = large) {
  Rest(detail, seconds, ViewOf(0, size));
  std::vector<DrawingDetail> details;
  for (int i = 1; i <= count; ++i) {
    details.push_back(detail.For(ViewOf(i, size), 0.01 * i));
    detail.Took(seconds(details.back()));
  }
  return details;
}

std::vector<int> StepsOf(const std::vector<DrawingDetail>& details) {
  std::vector<int> steps;
  for (const DrawingDetail& detail : details) steps.push_back(detail.pixel_step);
  return steps;
}

TEST(MotionDetail, StaysFullIfDrawingKeepsUpWithTheScreen) {
  MotionDetail detail;
  for (const DrawingDetail& drawn : Moving(detail, 4, ByPixels(0.008))) EXPECT_EQ(drawn, DrawingDetail{});
  EXPECT_FALSE(detail.RefinementTime());
}

TEST(MotionDetail, DropsTheFewestPixelsThatReachTheScreenRate) {
  for (const auto& [full, step] : {std::pair{0.017, 2}, {0.06, 2}, {0.07, 3}, {0.15, 3}, {0.16, 4}, {100.0, 9}}) {
    MotionDetail detail;
    EXPECT_EQ(StepsOf(Moving(detail, 2, ByPixels(full))), (std::vector{step, step})) << full;
  }
}

TEST(MotionDetail, DrawsInFullOnceTheViewRests) {
  MotionDetail detail;
  Moving(detail, 2, ByPixels(0.05));
  ASSERT_TRUE(detail.RefinementTime());
  const double due = *detail.RefinementTime();
  EXPECT_EQ(detail.For(ViewOf(2), due - 0.01).pixel_step, 2) << "what is drawn anew meanwhile does not flicker";
  EXPECT_EQ(*detail.RefinementTime(), due);
  EXPECT_EQ(detail.For(ViewOf(2), due), DrawingDetail{});
  EXPECT_FALSE(detail.RefinementTime());
}

TEST(MotionDetail, IsSmoothOnceTheViewRests) {
  MotionDetail detail;
  EXPECT_FALSE(Moving(detail, 4, ByPixels(0.012)).back().is_smooth) << "several samples per pixel would miss frames";
  ASSERT_TRUE(detail.RefinementTime());
  EXPECT_EQ(detail.For(ViewOf(4), *detail.RefinementTime()), DrawingDetail{});
  EXPECT_FALSE(detail.RefinementTime());
}

TEST(MotionDetail, StartsRoughUntilItsTimeIsKnown) {
  MotionDetail detail;
  EXPECT_FALSE(detail.For(ViewOf(0), 0).is_smooth);
  detail.Took(0.01);
  EXPECT_EQ(detail.RefinementTime(), 0) << "at once";
  EXPECT_EQ(detail.For(ViewOf(0), 0), DrawingDetail{});
}

TEST(MotionDetail, StaysRoughAtRestIfSmoothingWouldDelayEvents) {
  const auto slow_when_smooth = [](double rough, double smooth) {
    return [=](const DrawingDetail& detail) { return detail.is_smooth ? smooth : rough; };
  };
  MotionDetail known_beforehand, found_out, quick;
  EXPECT_FALSE(Rest(known_beforehand, slow_when_smooth(0.3, 3), ViewOf(0)).is_smooth);
  EXPECT_FALSE(known_beforehand.RefinementTime()) << "idle";
  EXPECT_TRUE(Rest(found_out, slow_when_smooth(0.15, 3), ViewOf(0)).is_smooth);
  EXPECT_FALSE(Rest(found_out, slow_when_smooth(0.15, 3), ViewOf(1), 1).is_smooth) << "once is enough";
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(Rest(quick, slow_when_smooth(0.15, 0.6), ViewOf(i), i).is_smooth);
}

TEST(MotionDetail, ForgetsTheTimesOfAnotherScene) {
  MotionDetail detail;
  Rest(detail, ByPixels(5), ViewOf(0));
  ray::FrameState other = ViewOf(0);
  other.faces = std::make_shared<const ray::PreviewScene>();
  EXPECT_TRUE(Rest(detail, ByPixels(0.01), other).is_smooth);
}

TEST(MotionDetail, LearnsNothingFromDrawingsOfATracedImage) {
  MotionDetail detail;
  Rest(detail, ByPixels(2), ViewOf(0));
  ray::FrameState traced = ViewOf(0);
  traced.covering.emplace();
  for (int i = 0; i < 3; ++i) {
    detail.For(traced, i);
    detail.Took(0.001);
  }
  EXPECT_GT(detail.For(ViewOf(1), 4).pixel_step, 1);
}

TEST(MotionDetail, ForgetsAFirstDrawingThatWasSlowForOnce) {
  MotionDetail detail;
  int drawn = 0;
  const auto slow_at_first = [&](const DrawingDetail& how) {
    return (drawn++ == 0 ? 0.3 : 0.002) / (how.pixel_step * how.pixel_step);
  };
  Moving(detail, 3, slow_at_first);
  Rest(detail, slow_at_first, ViewOf(3), 1);
  EXPECT_EQ(detail.For(ViewOf(4), 2), DrawingDetail{});
}

TEST(MotionDetail, KeepsEnoughPixelsInSmallWindows) {
  for (const auto& [size, step] :
       {std::pair<ray::DrawingSize, int>{{320, 200}, 1}, {{512, 512}, 2}, {{1280, 800}, 3}}) {
    MotionDetail detail;
    EXPECT_EQ(StepsOf(Moving(detail, 2, ByPixels(10), size)), (std::vector{step, step})) << size.width;
  }
}

TEST(MotionDetail, DrawsAStillViewInAllPixelsAnyNumberOfTimes) {
  MotionDetail detail;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(detail.For(ViewOf(0, {512, 512}), 0.01 * i).pixel_step, 1);
    detail.Took(1);
  }
}

}  // namespace

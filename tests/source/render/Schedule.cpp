#include "source/render/Schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ray {
namespace {

using Samples = std::vector<std::uint32_t>;

constexpr int columns = 6, blocks = columns * columns;

BlockGrid Grid() { return {columns, std::vector<double>(blocks, 64)}; }

RenderSettings UpTo(int samples) {
  RenderSettings settings;
  settings.samples = samples;
  return settings;
}

/// A target of 1 in the scene's units, so that squared errors are in squares of the target.
RenderSettings ToErrorOne(int samples = 1) {
  RenderSettings settings = UpTo(samples);
  settings.budget.error = ErrorTarget{1, ErrorUnit::linear};
  return settings;
}

RenderSettings Within(double seconds) {
  RenderSettings settings;
  settings.budget.seconds = seconds;
  return settings;
}

/// A pass that found these squared errors in the blocks.
PassOutcome Found(const std::vector<double>& squares, double outlier_share = 0) {
  MeasuredError error;
  error.square_of_blocks = squares;
  error.square = std::accumulate(squares.begin(), squares.end(), 0.0) / blocks;
  error.square_high = 1.1 * error.square;
  error.mean = 1;
  error.estimate.outlier_share = outlier_share;
  return {.now = 1, .seconds_taken = 1, .samples_taken = 1, .error = error};
}
PassOutcome Found(double square) { return Found(std::vector<double>(blocks, square)); }

/// The same squared error everywhere but in the first block, in the corner.
PassOutcome FoundInCorner(double corner, double elsewhere, double outlier_share = 0) {
  std::vector<double> squares(blocks, elsewhere);
  squares[0] = corner;
  return Found(squares, outlier_share);
}

Samples AllAt(std::uint32_t samples) { return Samples(blocks, samples); }

TEST(Schedule, WithoutABudgetIsOnePass) {
  Schedule schedule(UpTo(6), Grid(), false);
  EXPECT_EQ(schedule.State().targets, AllAt(6));
  EXPECT_EQ(schedule.Next({}), Stop::samples);
}

TEST(Schedule, PassesThatAreAskedForDoubleTheSamples) {
  Schedule schedule(UpTo(6), Grid(), true);
  for (const std::uint32_t end : {1u, 2u, 4u, 6u}) {
    EXPECT_EQ(schedule.State().end, end);
    EXPECT_EQ(schedule.State().targets, AllAt(end));
    EXPECT_EQ(schedule.Next({}), end == 6 ? std::optional(Stop::samples) : std::nullopt);
  }
}

TEST(Schedule, AnErrorTargetHalvesTheCeilingBetweenTwoStreams) {
  EXPECT_TRUE(HasTwoStreams(ToErrorOne()));
  Schedule schedule(ToErrorOne(64), Grid(), false);
  for (const std::uint32_t end : {8u, 16u, 32u}) {
    EXPECT_EQ(schedule.State().end, end);
    EXPECT_EQ(schedule.Next(Found(100)), end == 32 ? std::optional(Stop::samples) : std::nullopt);
  }
}

TEST(Schedule, StopsWhenTheUpperEndOfTheErrorIsBelowTheTarget) {
  Schedule schedule(ToErrorOne(), Grid(), false);
  EXPECT_FALSE(schedule.Next(Found(0.95))) << "the estimate is below 1, the end of its interval at 1.045";
  EXPECT_EQ(schedule.Next(Found(0.9)), Stop::error);
}

TEST(Schedule, TakesFewerThanTwiceTheSamplesWhenTheErrorIsNearItsTarget) {
  Schedule far(ToErrorOne(), Grid(), false), near = far;
  EXPECT_FALSE(far.Next(Found(4)));
  EXPECT_EQ(far.State().end, 16u);
  EXPECT_FALSE(near.Next(Found(1)));
  EXPECT_GT(near.State().end, 8u);
  EXPECT_LT(near.State().end, 12u);
}

TEST(Schedule, TooFewSamplesDecideNothingByTheirError) {
  RenderSettings settings = ToErrorOne();
  settings.budget.seconds = 1e6;
  Schedule schedule(settings, Grid(), false);
  for (const std::uint32_t end : {1u, 2u, 4u}) {
    EXPECT_EQ(schedule.State().end, end);
    EXPECT_FALSE(schedule.Next(Found(0)));
  }
  EXPECT_EQ(schedule.Next(Found(0)), Stop::error);
}

// One look may see a small error by luck; light that it missed would be missing from the picture.
TEST(Schedule, ABlockClosesAfterTwoLooksAndOnlyAwayFromBlocksThatAreOpen) {
  Schedule schedule(ToErrorOne(), Grid(), false);
  ASSERT_FALSE(schedule.Next(FoundInCorner(1000, 0.1)));
  EXPECT_EQ(schedule.State().targets, AllAt(16));
  ASSERT_FALSE(schedule.Next(FoundInCorner(1000, 0.1)));
  for (int i = 0; i < blocks; ++i) {
    const bool is_beside_corner = i % columns <= 1 && i / columns <= 1;
    EXPECT_EQ(schedule.State().targets[static_cast<std::size_t>(i)], is_beside_corner ? 32u : 16u) << i;
  }
}

TEST(Schedule, WithoutAdaptiveSamplingEveryBlockGoesOn) {
  RenderSettings settings = ToErrorOne();
  settings.budget.adaptive = Adaptive::off;
  Schedule schedule(settings, Grid(), false);
  for (const std::uint32_t end : {8u, 16u, 32u, 64u}) {
    EXPECT_EQ(schedule.State().targets, AllAt(end));
    ASSERT_FALSE(schedule.Next(FoundInCorner(1000, 0.1)));
  }
}

// Rare bright samples: where the last pass found them nobody would have looked, so nobody knows where the next are.
TEST(Schedule, OutliersWhereBlocksWouldHaveClosedKeepAllOpen) {
  for (const double outlier_share : {0.4, 0.6}) {
    Schedule schedule(ToErrorOne(), Grid(), false);
    ASSERT_FALSE(schedule.Next(Found(std::vector<double>{[] {
      std::vector<double> squares(blocks, 0.1);
      squares.back() = 1000;
      return squares;
    }()})));
    ASSERT_FALSE(schedule.Next(FoundInCorner(1000, 0.1, outlier_share)));
    EXPECT_EQ(schedule.State().targets == AllAt(32), outlier_share > 0.5);
  }
}

TEST(Schedule, OutliersThatStayWhereTheyWereKeepOnlyTheirBlocksOpen) {
  Schedule schedule(ToErrorOne(), Grid(), false);
  ASSERT_FALSE(schedule.Next(FoundInCorner(1000, 0.1, 0.9)));
  ASSERT_FALSE(schedule.Next(FoundInCorner(1000, 0.1, 0.9)));
  EXPECT_EQ(schedule.State().targets.front(), 32u);
  EXPECT_EQ(schedule.State().targets.back(), 16u);
}

/// The ends of the passes of a render that takes `seconds_per_sample`, and when the last was over.
std::pair<Samples, double> RunOnClock(double budget, double seconds_per_sample) {
  Schedule schedule(Within(budget), Grid(), false);
  Samples ends;
  double now = 0;
  std::optional<Stop> stop;
  for (std::uint32_t done = 0; !stop; done = ends.back()) {
    ends.push_back(schedule.State().end);
    const double samples = ends.back() - done, seconds = seconds_per_sample * samples;
    now += seconds;
    stop = schedule.Next({.now = now, .seconds_taken = seconds, .samples_taken = samples, .error = {}});
    if (ends.size() > 100) break;
  }
  EXPECT_EQ(stop, Stop::time);
  return {ends, now};
}

TEST(Schedule, ATimeBudgetShortensTheLastPasses) {
  const auto [ends, now] = RunOnClock(10, 1);
  // 4 of the 5.7 s left after four samples would be too many at once, so 3.
  EXPECT_EQ(ends, (Samples{1, 2, 4, 7, 8, 9}));
  EXPECT_EQ(now, 9);
}

TEST(Schedule, ATimeBudgetIsUsedButNotExceededAtAnySpeed) {
  for (double seconds_per_sample = 0.9; seconds_per_sample > 1e-5; seconds_per_sample *= 0.83) {
    const double now = RunOnClock(10, seconds_per_sample).second;
    EXPECT_LE(now, 9.7) << seconds_per_sample;
    EXPECT_GT(now, 9.7 - seconds_per_sample - 0.01) << seconds_per_sample;
  }
}

TEST(Schedule, WithoutTimeForAnotherSampleStops) {
  Schedule schedule(Within(10), Grid(), false);
  EXPECT_EQ(schedule.Next({.now = 6, .seconds_taken = 6, .samples_taken = 1, .error = {}}), Stop::time);
}

// A render that resumes at the very end of a pass has not yet seen how fast it is.
TEST(Schedule, WhereNoPassToldTheSpeedTheNextTakesOneSample) {
  Schedule schedule(Within(10), Grid(), false);
  schedule.Resume({AllAt(64), {}, 64});
  Schedule late = schedule;
  EXPECT_FALSE(schedule.Next({.now = 1, .seconds_taken = 1e-6, .samples_taken = 0, .error = {}}));
  EXPECT_EQ(schedule.State().targets, AllAt(65));
  EXPECT_EQ(late.Next({.now = 11, .seconds_taken = 1e-6, .samples_taken = 0, .error = {}}), Stop::time);
}

/// What a pass of an unevenly lit picture finds: errors fall with the samples, and far more slowly in two corners.
PassOutcome Lifelike(const Schedule& schedule) {
  std::vector<double> squares(blocks);
  for (int i = 0; i < blocks; ++i) {
    const double samples = schedule.State().targets[static_cast<std::size_t>(i)];
    squares[static_cast<std::size_t>(i)] = (i == 0 || i == blocks - 2 ? 500 : 2.0 + i % 5) / samples;
  }
  return Found(squares);
}

TEST(Schedule, AReplayEndsWithTheSamplesOfTheRenderItRepeats) {
  Schedule schedule(ToErrorOne(), Grid(), false);
  Replay replay{true, PlannedSamples(ToErrorOne()), {}, {}};
  std::optional<Stop> stop;
  while (!stop) {
    replay.ends.push_back(schedule.State().end);
    stop = schedule.Next(Lifelike(schedule));
  }
  ASSERT_EQ(stop, Stop::error);
  replay.samples = schedule.State().targets;
  ASSERT_LT(*std::min_element(replay.samples.begin(), replay.samples.end()) * 2, replay.samples.front())
      << "adaptive sampling had nothing to do";

  RenderSettings settings = UpTo(1);
  settings.replay = replay;
  EXPECT_EQ(PlannedSamples(settings), PlannedSamples(ToErrorOne()));
  EXPECT_TRUE(HasTwoStreams(settings));
  Schedule again(settings, Grid(), false);
  Samples ends{again.State().end};
  while (!again.Next({})) ends.push_back(again.State().end);
  EXPECT_EQ(ends, replay.ends);
  EXPECT_EQ(again.State().targets, replay.samples);
}

TEST(Schedule, GoesOnFromItsStateToTheSameDecisions) {
  Schedule whole(ToErrorOne(), Grid(), false);
  std::optional<Stop> stop;
  int passes = 0;
  while (!stop) {
    Schedule resumed(ToErrorOne(), Grid(), false);
    resumed.Resume(whole.State());
    stop = whole.Next(Lifelike(whole));
    EXPECT_EQ(resumed.Next(Lifelike(resumed)), stop);
    EXPECT_EQ(resumed.State().targets, whole.State().targets);
    EXPECT_EQ(resumed.State().last_squared_errors, whole.State().last_squared_errors);
    EXPECT_EQ(resumed.State().end, whole.State().end);
    ++passes;
  }
  EXPECT_GT(passes, 4);
}

TEST(Schedule, AReplayGoesOnFromTheMiddle) {
  RenderSettings settings = UpTo(1);
  settings.replay = Replay{false, 8, {1, 2, 4, 8}, {}};
  Schedule schedule(settings, Grid(), false);
  schedule.Resume({AllAt(4), {}, 4});
  EXPECT_EQ(schedule.State().end, 4u);
  EXPECT_FALSE(schedule.Next({}));
  EXPECT_EQ(schedule.State().targets, AllAt(8));
  EXPECT_EQ(schedule.Next({}), Stop::samples);
}

// A viewer's first samples are made in an order of its own; the one pass of a render then takes what is left.
TEST(Schedule, OnePassTakesWhatIsLeftOfAnEarlierPass) {
  Schedule schedule(UpTo(6), Grid(), false);
  schedule.Resume({AllAt(1), {}, 1});
  EXPECT_EQ(schedule.State().targets, AllAt(6));
}

}  // namespace
}  // namespace ray

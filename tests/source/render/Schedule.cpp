#include "source/render/Schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
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

/// Returns settings with a target of 1 in the scene's units, so that squared errors are in squares of the target.
RenderSettings ToErrorOne(int samples = 1, double seconds = 0) {
  RenderSettings settings = UpTo(samples);
  settings.budget.seconds = seconds;
  settings.budget.error = ErrorTarget{1, ErrorUnit::linear};
  return settings;
}

RenderSettings Allotting(Adaptive adaptive, RenderSettings settings) {
  settings.budget.adaptive = adaptive;
  return settings;
}

RenderSettings Within(double seconds) {
  RenderSettings settings;
  settings.budget.seconds = seconds;
  return settings;
}

/// Returns a pass that measured these squared errors in the blocks.
PassOutcome Found(const std::vector<double>& squares) {
  MeasuredError error;
  error.square_of_blocks = squares;
  error.square = std::accumulate(squares.begin(), squares.end(), 0.0) / blocks;
  error.square_high = 1.1 * error.square;
  error.mean = 1;
  return {.now = 1, .seconds_taken = 1, .samples_taken = 1, .error = error};
}
PassOutcome Found(double square) { return Found(std::vector<double>(blocks, square)); }

/// Returns a pass with one squared error everywhere except in the first block, in the corner.
PassOutcome FoundInCorner(double corner, double elsewhere) {
  std::vector<double> squares(blocks, elsewhere);
  squares[0] = corner;
  return Found(squares);
}

Samples AllAt(std::uint32_t samples) { return Samples(blocks, samples); }

/// Returns a first look at a pixel of each block that took no time.
const PassOutcome quick_look{.now = 0, .seconds_taken = 1e-9, .samples_taken = 1.0 / BlockOrder::places, .error = {}};

/// Advances past the looks, to the first samples.
Schedule Sampling(const RenderSettings& settings) {
  Schedule schedule(settings, Grid(), false);
  EXPECT_FALSE(schedule.Next(quick_look));
  EXPECT_EQ(schedule.State().targets, PassTargets{AllAt(1)});
  return schedule;
}

/// Advances to the first look at an error, at 8 samples of each stream.
Schedule Deciding(const RenderSettings& settings) {
  Schedule schedule = Sampling(settings);
  for (const std::uint32_t end : {1u, 2u, 4u}) {
    EXPECT_EQ(schedule.State().end, end);
    EXPECT_FALSE(schedule.DecidesByError());
    EXPECT_FALSE(schedule.Next(quick_look));
  }
  EXPECT_TRUE(schedule.DecidesByError());
  return schedule;
}

TEST(Schedule, TakesAnyNumberOfRequestedSamples) {
  for (const int samples : {3, 1'000'000, 1 << 30, (1 << 30) + 1, std::numeric_limits<int>::max()}) {
    Schedule schedule = Sampling(UpTo(samples));
    while (!schedule.Next(quick_look)) continue;
    EXPECT_EQ(schedule.State().targets.samples, AllAt(static_cast<std::uint32_t>(samples)));
  }
}

TEST(Schedule, BeginsWithALookAtAPixelOfEachBlock) {
  const Schedule schedule(UpTo(6), Grid(), false);
  EXPECT_EQ(schedule.State().end, 0u);
  EXPECT_EQ(schedule.State().targets, (PassTargets{AllAt(0), std::vector<std::uint8_t>(blocks, 1)}));
}

/// Returns the numbers of places at which looks end, if a whole sample costs that many seconds, until samples begin or
/// it stops.
std::vector<int> Looks(const RenderSettings& settings, double seconds_per_sample) {
  Schedule schedule(settings, Grid(), false);
  std::vector<int> looks;
  double now = 0;
  for (int done = 0; schedule.State().end == 0;) {
    const int places = schedule.State().targets.PlacesOf(0);
    looks.push_back(places);
    const double samples = static_cast<double>(places - done) / BlockOrder::places;
    now += seconds_per_sample * samples;
    if (schedule.Next({now, seconds_per_sample * samples, samples, {}})) break;
    done = places;
  }
  return looks;
}

TEST(Schedule, DoublesItsLooksUntilTheRestTakesASecond) {
  EXPECT_EQ(Looks(UpTo(6), 0.5), (std::vector<int>{1}));
  EXPECT_EQ(Looks(UpTo(6), 1.9), (std::vector<int>{1, 2, 4, 8, 16, 32}));
  EXPECT_EQ(Looks(UpTo(6), 1000), (std::vector<int>{1, 2, 4, 8, 16, 32}));
}

TEST(Schedule, LooksContinueUntilTimeRunsOut) {
  for (const double seconds_per_sample : {11.0, 30.0, 100.0, 400.0}) {
    const double place = seconds_per_sample / BlockOrder::places;
    const double used = Looks(Within(10), seconds_per_sample).back() * place;
    EXPECT_LE(used - place, 9.6) << seconds_per_sample;
    EXPECT_GT(used, 9.6) << seconds_per_sample;
  }
}

TEST(Schedule, ReservesTimeForTheWorkAfterTheSamples) {
  constexpr double pace = 0.02, fixed = 1.5, after_each = 0.03;  // seconds of a sample; after all of them
  RenderSettings settings = Within(10);
  settings.denoise = true;
  Schedule schedule(settings, Grid(), false);
  double now = 0, samples = 0;
  std::optional<Stop> stop;
  for (int pass = 0; !stop && pass < 100; ++pass) {
    const PassTargets& targets = schedule.State().targets;
    double taken = 0;
    for (int i = 0; i < blocks; ++i)
      taken += targets.samples[static_cast<std::size_t>(i)] > 0 ? 2.0 * targets.samples[static_cast<std::size_t>(i)]
                                                                : 1.0 / BlockOrder::places;
    taken = taken / blocks - samples;
    samples += taken, now += pace * taken;
    stop = schedule.Next({.now = now,
                          .seconds_taken = pace * taken,
                          .samples_taken = taken,
                          .error = {},
                          .seconds_after = fixed + after_each * samples,
                          .seconds_after_per_sample = after_each});
  }
  EXPECT_EQ(stop, Stop::time);
  EXPECT_LE(now + fixed + after_each * samples, 9.75);
  EXPECT_GE(now + fixed + after_each * samples, 9.5);
}

TEST(Schedule, ModesThatShowCostsAreOnePass) {
  RenderSettings settings = UpTo(6);
  settings.mode = RenderMode::heat;
  Schedule schedule(settings, Grid(), false);
  EXPECT_EQ(schedule.State().targets, PassTargets{AllAt(6)});
  EXPECT_EQ(schedule.Next({}), Stop::samples);
}

TEST(Schedule, PassesDoubleTheSamples) {
  Schedule schedule = Sampling(UpTo(6));
  for (const std::uint32_t end : {1u, 2u, 4u, 6u}) {
    EXPECT_EQ(schedule.State().end, end);
    EXPECT_EQ(schedule.State().targets, PassTargets{AllAt(end)});
    EXPECT_EQ(schedule.Next({}), end == 6 ? std::optional(Stop::samples) : std::nullopt);
  }
}

TEST(Schedule, AnErrorTargetHalvesTheCeilingBetweenTwoStreams) {
  EXPECT_TRUE(HasTwoStreams(ToErrorOne()));
  Schedule schedule = Deciding(ToErrorOne(64));
  for (const std::uint32_t end : {8u, 16u, 32u}) {
    EXPECT_EQ(schedule.State().end, end);
    EXPECT_EQ(schedule.Next(Found(100)), end == 32 ? std::optional(Stop::samples) : std::nullopt);
  }
}

TEST(Schedule, StopsWhenTheErrorsUpperBoundMeetsTheTarget) {
  Schedule schedule = Deciding(ToErrorOne());
  EXPECT_FALSE(schedule.Next(Found(0.95))) << "the estimate is below 1, the end of its interval at 1.045";
  EXPECT_EQ(schedule.Next(Found(0.9)), Stop::error);
}

TEST(Schedule, LessThanDoublesTheSamplesNearItsTarget) {
  Schedule far = Deciding(ToErrorOne()), near = far;
  EXPECT_FALSE(far.Next(Found(4)));
  EXPECT_EQ(far.State().end, 16u);
  EXPECT_FALSE(near.Next(Found(1)));
  EXPECT_GT(near.State().end, 8u);
  EXPECT_LT(near.State().end, 12u);
}

// In between, (0,2)-sequences are worse than with fewer samples.
TEST(Schedule, PassesEndAtQuartersOfTheLastPowerOfTwo) {
  for (const double square : {0.92, 1.0, 1.2, 1.5, 2.0, 3.0}) {
    Schedule schedule = Deciding(ToErrorOne());
    std::uint32_t last = schedule.State().end;
    while (last < 10000) {
      EXPECT_FALSE(schedule.Next(Found(square)));
      const std::uint32_t end = schedule.State().end;
      EXPECT_GT(end, last);
      EXPECT_LE(end, 2 * last);
      EXPECT_EQ(end % (std::bit_floor(last) / 4), 0u) << last << " to " << end;
      last = end;
    }
  }
}

TEST(Schedule, TooFewSamplesDecideNothingByTheirError) {
  Schedule schedule = Sampling(ToErrorOne(1, 1e6));
  for (const std::uint32_t end : {1u, 2u}) {
    EXPECT_EQ(schedule.State().end, end);
    EXPECT_FALSE(schedule.Next(Found(0)));
  }
  EXPECT_EQ(schedule.Next(Found(0)), Stop::error);
}

TEST(Schedule, AFirstErrorMustMeetTheTargetWithDoubledSquare) {
  Schedule surely = Sampling(ToErrorOne());
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(surely.Next(Found(0)));
  Schedule perhaps = surely;
  EXPECT_EQ(surely.Next(Found(0.45)), Stop::error) << "the end of twice its interval is at .99";
  EXPECT_FALSE(perhaps.Next(Found(0.5)));
}

// Coarse targets are met by four samples of each stream; finer ones would change if anything else were decided there.
TEST(Schedule, AFirstErrorThatIsTooLargeLeavesNoTrace) {
  Schedule looks = Sampling(ToErrorOne(1, 1e6));
  for (const std::uint32_t end : {1u, 2u, 4u}) {
    EXPECT_EQ(looks.State().end, end);
    EXPECT_FALSE(looks.Next(Found(1.1)));
  }
  const Schedule without = Deciding(ToErrorOne(1, 1e6));
  EXPECT_EQ(looks.State().targets, without.State().targets);
}

// A measurement may be small by chance, so the neighbors of a noisy block continue as well.
TEST(Schedule, NoisyBlocksContinueWithTheirNeighbors) {
  Schedule schedule = Deciding(ToErrorOne());
  ASSERT_FALSE(schedule.Next(FoundInCorner(40, 0.1)));
  for (std::size_t i = 0; i < blocks; ++i) {
    const bool is_beside_corner = i % columns <= 1 && i / columns <= 1;
    EXPECT_EQ(schedule.State().targets.samples[i], is_beside_corner ? schedule.State().end : 8u) << i;
  }
}

/// Renders an image of which a row of blocks is noisier than the others, to a squared error of 1. Squared errors are
/// variances over samples. Returns the samples of all blocks, per stream.
Samples SamplesToErrorOne(Adaptive adaptive, double variance, double noisier) {
  Schedule schedule = Deciding(Allotting(adaptive, ToErrorOne()));
  const auto measure = [&] {
    std::vector<double> squares;
    for (const std::uint32_t samples : schedule.State().targets.samples)
      squares.push_back((squares.size() < columns ? noisier : 1) * variance / samples);
    return Found(squares);
  };
  while (!schedule.Next(measure())) continue;
  return schedule.State().targets.samples;
}

// The optimum is (mean deviation)^2 / target^2 (Cochran, Sampling Techniques, 1977, equation 5.27). Blocks next to the
// noisy row count as half as noisy.
TEST(Schedule, SamplesAreNearlyAsFewAsTheBestAllocation) {
  const double variance = 20, noisier = 400, rows = columns;
  const double mean_deviation = std::sqrt(variance) * (1.5 * std::sqrt(noisier) + rows - 2) / rows;
  const double best = mean_deviation * mean_deviation;
  const auto mean = [](const Samples& all) { return std::accumulate(all.begin(), all.end(), 0.0) / blocks; };
  const Samples adaptive = SamplesToErrorOne(Adaptive::tile, variance, noisier);
  EXPECT_LT(mean(adaptive), 1.5 * best);
  EXPECT_GT(mean(SamplesToErrorOne(Adaptive::off, variance, noisier)), 2 * best);
  EXPECT_GE(8 * std::ranges::min(adaptive), mean(adaptive)) << "too few to find rare light";
}

/// Returns the blocks that gain samples; those of a square must gain equally many.
int GainsOfSquares(const BlockGrid& grid, const Samples& before, const Samples& after) {
  int gaining = 0;
  const auto side = static_cast<std::size_t>(grid.together);
  for (std::size_t i = 0; i < blocks; ++i) {
    EXPECT_EQ(after[i], after[i / columns / side * side * columns + i % columns / side * side]);
    gaining += after[i] > before[i];
  }
  return gaining;
}

TEST(Schedule, SquaresOfBlocksThatShareLightContinueTogether) {
  const BlockGrid fours{columns, std::vector<double>(blocks, 64), 4}, twos{columns, fours.areas, 2};
  Schedule to_error(ToErrorOne(), fours, false), within(Within(10), twos, false);
  while (!to_error.DecidesByError()) ASSERT_FALSE(to_error.Next(quick_look));
  Samples before = to_error.State().targets.samples;
  ASSERT_FALSE(to_error.Next(FoundInCorner(100, .1)));
  EXPECT_EQ(GainsOfSquares(fours, before, to_error.State().targets.samples), 16);
  ASSERT_FALSE(within.Next(quick_look));
  before = within.State().targets.samples;
  ASSERT_FALSE(within.Next({.now = 9.2, .seconds_taken = 1, .samples_taken = 1, .error = {}}));
  const int gaining = GainsOfSquares(twos, before, within.State().targets.samples);
  EXPECT_GT(gaining, 0);
  EXPECT_LE(gaining, blocks / 2);
}

TEST(Schedule, WithoutAdaptiveSamplingEveryBlockContinues) {
  Schedule schedule = Deciding(Allotting(Adaptive::off, ToErrorOne()));
  for (const std::uint32_t end : {8u, 16u, 32u, 64u}) {
    EXPECT_EQ(schedule.State().targets.samples, AllAt(end));
    ASSERT_FALSE(schedule.Next(FoundInCorner(1000, 0.1)));
  }
}

// Light that no sample has found raises no block's error. If blocks stopped nevertheless, the rest would continue until
// the whole image seemed good enough, and light found later would be missing from all blocks that had stopped.
TEST(Schedule, LightThatNoSampleHasFoundKeepsAllBlocksOpen) {
  for (const double unseen_share : {0.0, 0.04, 0.06, 0.9}) {
    Schedule schedule = Deciding(ToErrorOne());
    PassOutcome pass = FoundInCorner(40, 0.1);
    pass.error->estimate.unseen_share = unseen_share;
    ASSERT_FALSE(schedule.Next(pass));
    EXPECT_EQ(schedule.State().targets.samples == AllAt(schedule.State().end), unseen_share > 0.05) << unseen_share;
  }
}

/// Returns the samples per pixel of a render that takes `seconds_per_sample`, and the time when it ends.
std::pair<double, double> RunOnClock(double budget, double seconds_per_sample) {
  Schedule schedule = Sampling(Within(budget));
  double now = 0, done = 0;
  std::optional<Stop> stop;
  for (int passes = 0; !stop && passes < 100; ++passes) {
    const Samples& targets = schedule.State().targets.samples;
    const double mean = std::accumulate(targets.begin(), targets.end(), 0.0) / blocks;
    const double samples = mean - done, seconds = seconds_per_sample * samples;
    EXPECT_GT(samples, 0);
    EXPECT_EQ(schedule.State().end, *std::ranges::max_element(targets));
    EXPECT_LE(schedule.State().end, std::ceil(mean)) << "a block is ahead of the others by more than one sample";
    now += seconds;
    done = mean;
    stop = schedule.Next({.now = now, .seconds_taken = seconds, .samples_taken = samples, .error = {}});
  }
  EXPECT_EQ(stop, Stop::time);
  return {done, now};
}

TEST(Schedule, UsesUpButNeverExceedsTheTimeBudget) {
  for (double seconds_per_sample = 9; seconds_per_sample > 1e-5; seconds_per_sample *= 0.83) {
    const auto [samples, now] = RunOnClock(10, seconds_per_sample);
    EXPECT_LE(now, 9.7) << seconds_per_sample;
    // Less than a hundredth of the time, or a sample of one block, is too little to continue.
    EXPECT_GT(now, 9.7 - 0.1 - 2 * seconds_per_sample / blocks) << seconds_per_sample;
    EXPECT_NEAR(samples * seconds_per_sample, now, 1e-9);
  }
}

TEST(Schedule, TheRemainingTimeIsSpreadOverTheImage) {
  Schedule schedule = Sampling(Within(10));
  ASSERT_FALSE(schedule.Next({.now = 5, .seconds_taken = 5, .samples_taken = 1, .error = {}}));
  const Samples& targets = schedule.State().targets.samples;
  for (int row = 0; row < columns; ++row) {
    const auto begin = targets.begin() + row * columns;
    const auto gained = std::count(begin, begin + columns, 2u);
    EXPECT_GE(gained, columns / 3) << row;
    EXPECT_LT(gained, columns) << row;
  }
}

TEST(Schedule, WithoutTimeForAnotherSampleStops) {
  Schedule schedule = Sampling(Within(10));
  EXPECT_EQ(schedule.Next({.now = 9.65, .seconds_taken = 9, .samples_taken = 1, .error = {}}), Stop::time);
}

// A render that resumes at the very end of a pass does not know its speed yet.
TEST(Schedule, AtUnknownSpeedTheNextPassTakesOneSample) {
  Schedule schedule(Within(10), Grid(), false);
  schedule.Resume({{AllAt(64)}, 64});
  Schedule late = schedule;
  EXPECT_FALSE(schedule.Next({.now = 1, .seconds_taken = 1e-6, .samples_taken = 0, .error = {}}));
  EXPECT_EQ(schedule.State().targets.samples, AllAt(65));
  EXPECT_EQ(late.Next({.now = 11, .seconds_taken = 1e-6, .samples_taken = 0, .error = {}}), Stop::time);
}

/// Returns the errors of a pass in an unevenly lit image: they fall with the samples, and far more slowly in two
/// corners.
PassOutcome Lifelike(const Schedule& schedule) {
  std::vector<double> squares(blocks);
  for (int i = 0; i < blocks; ++i) {
    const double samples = schedule.State().targets.samples[static_cast<std::size_t>(i)];
    squares[static_cast<std::size_t>(i)] = (i == 0 || i == blocks - 2 ? 500 : 2.0 + i % 5) / samples;
  }
  return Found(squares);
}

TEST(Schedule, ManyMachinesGoAsFarAsTheirPaceAllows) {
  Schedule one = Sampling(Within(100)), many = Sampling(Within(100));
  PassOutcome pass{.now = 1, .seconds_taken = 1, .samples_taken = 1, .error = {}};
  EXPECT_FALSE(one.Next(pass));
  EXPECT_EQ(one.State().end, 2u);
  pass.is_of_many_machines = true;
  EXPECT_FALSE(many.Next(pass));
  // They get 0.6 of the 96 seconds that are left until 97% of the time, at a second per sample, after the existing one.
  EXPECT_EQ(many.State().targets, PassTargets{AllAt(58)});
  Schedule with_error = Sampling(ToErrorOne(1, 100));
  EXPECT_FALSE(with_error.Next(pass));
  EXPECT_EQ(with_error.State().end, 2u) << "errors decide at samples that double";
}

TEST(Schedule, AReplayEndsWithTheOriginalSamples) {
  Schedule schedule = Deciding(ToErrorOne());
  Replay replay{true, PlannedSamples(ToErrorOne()), {}, {}, {}};
  std::optional<Stop> stop;
  while (!stop) {
    replay.ends.push_back(schedule.State().end);
    stop = schedule.Next(Lifelike(schedule));
  }
  ASSERT_EQ(stop, Stop::error);
  replay.samples = schedule.State().targets.samples;
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
  EXPECT_EQ(again.State().targets.samples, replay.samples);
}

TEST(Schedule, ResumesFromItsStateWithTheSameDecisions) {
  Schedule whole(ToErrorOne(), Grid(), false);
  std::optional<Stop> stop;
  int passes = 0;
  while (!stop) {
    Schedule resumed(ToErrorOne(), Grid(), false);
    resumed.Resume(whole.State());
    stop = whole.Next(Lifelike(whole));
    EXPECT_EQ(resumed.Next(Lifelike(resumed)), stop);
    EXPECT_EQ(resumed.State().targets, whole.State().targets);
    EXPECT_EQ(resumed.State().end, whole.State().end);
    ++passes;
  }
  EXPECT_GT(passes, 4);
}

TEST(Schedule, AReplayResumesFromTheMiddle) {
  RenderSettings settings = UpTo(1);
  settings.replay = Replay{false, 8, {1, 2, 4, 8}, {}, {}};
  Schedule schedule(settings, Grid(), false);
  schedule.Resume({{AllAt(4)}, 4});
  EXPECT_EQ(schedule.State().end, 4u);
  EXPECT_FALSE(schedule.Next({}));
  EXPECT_EQ(schedule.State().targets.samples, AllAt(8));
  EXPECT_EQ(schedule.Next({}), Stop::samples);
}

// A viewer's first samples are taken in its own order.
TEST(Schedule, ContinuesFromSamplesTakenElsewhere) {
  Schedule schedule(UpTo(6), Grid(), false);
  schedule.Resume({{AllAt(1)}, 1});
  EXPECT_EQ(schedule.State().targets, PassTargets{AllAt(1)});
  EXPECT_FALSE(schedule.Next({}));
  EXPECT_EQ(schedule.State().targets, PassTargets{AllAt(2)});
}

TEST(Schedule, AReplayMayEndInTheFirstSample) {
  RenderSettings settings = UpTo(1);
  std::vector<std::uint8_t> places(blocks, 4);
  places[7] = 8;
  settings.replay = Replay{false, 8, {0}, AllAt(0), places};
  Schedule schedule(settings, Grid(), false);
  EXPECT_EQ(schedule.State().targets, (PassTargets{AllAt(0), places}));
  EXPECT_EQ(schedule.Next({}), Stop::samples);
}

/// Returns the end of a render whose error has not fallen for long.
std::optional<Stop> EndOfStalled(const RenderSettings& settings) {
  Schedule schedule(settings, Grid(), false);
  schedule.Next(quick_look);
  std::optional<Stop> stop;
  for (int pass = 0; pass < 8 && !stop; ++pass) {
    PassOutcome found = Found(4);
    found.has_stalled = pass == 6;
    stop = schedule.Next(found);
  }
  return stop;
}

TEST(Schedule, AStalledErrorEndsARenderWithoutOtherLimits) { EXPECT_EQ(EndOfStalled(ToErrorOne()), Stop::stall); }

TEST(Schedule, AStalledErrorEndsNoRenderWithOtherLimits) {
  EXPECT_EQ(EndOfStalled(ToErrorOne(1 << 20)), std::nullopt);
  EXPECT_EQ(EndOfStalled(ToErrorOne(1, 1000)), std::nullopt);
}

/// Returns a pass in which neighbors differ by that many levels, in the block in the corner alone.
PassOutcome UnlikeInCorner(double levels) {
  PassOutcome pass{.now = 1, .seconds_taken = 1, .samples_taken = 1, .error = {}};
  pass.contrasts.assign(blocks, 0.99 / 255);
  pass.contrasts[0] = levels / 255;
  return pass;
}

TEST(Schedule, OfNeighborsGivesDifferingBlocksAllSamplesAtOnce) {
  const RenderSettings settings = Allotting(Adaptive::neighbors, UpTo(9));
  Schedule schedule(settings, Grid(), false);
  EXPECT_FALSE(schedule.LooksAtContrast());
  EXPECT_FALSE(schedule.Next(quick_look));
  EXPECT_EQ(schedule.State().targets.samples, AllAt(1));
  EXPECT_TRUE(schedule.LooksAtContrast());
  EXPECT_FALSE(schedule.Next(UnlikeInCorner(1.01)));
  Samples corner = AllAt(1);
  corner[0] = 9;
  EXPECT_EQ(schedule.State().targets.samples, corner);
  EXPECT_FALSE(schedule.LooksAtContrast());
  EXPECT_EQ(schedule.Next(UnlikeInCorner(0)), Stop::samples);

  Schedule alike(settings, Grid(), false);
  EXPECT_FALSE(alike.Next(quick_look));
  EXPECT_EQ(alike.Next(UnlikeInCorner(0.99)), Stop::samples) << "a level or less is alike";
}

TEST(Schedule, OfNeighborsResumesTheSameBlocksWithMoreSamples) {
  Samples corner = AllAt(1);
  corner[0] = 4;
  Schedule schedule(Allotting(Adaptive::neighbors, UpTo(9)), Grid(), false);
  schedule.Resume({.targets = {corner}, .end = 4});
  EXPECT_FALSE(schedule.Next(UnlikeInCorner(0)));
  corner[0] = 9;
  EXPECT_EQ(schedule.State().targets.samples, corner);
}

TEST(Schedule, OfNeighborsIsOffForBudgetsAndCostModes) {
  Schedule to_error(Allotting(Adaptive::neighbors, ToErrorOne(9)), Grid(), false);
  EXPECT_FALSE(to_error.Next(quick_look));
  EXPECT_FALSE(to_error.LooksAtContrast());
  RenderSettings settings = Allotting(Adaptive::neighbors, UpTo(9));
  settings.mode = RenderMode::heat;
  EXPECT_EQ(Schedule(settings, Grid(), false).State().targets.samples, AllAt(9));
}

// Each look requires filtering, so there are few: at half of the samples that a large error needs, and at slightly more
// than all that a small one needs.
TEST(Schedule, DenoisedImagesAreLookedAtRarely) {
  RenderSettings settings = ToErrorOne();
  settings.denoise = true;
  Schedule schedule = Deciding(settings);
  const auto found = [](double denoised, double noisy) {
    PassOutcome pass = Found(denoised);
    pass.noisy = Found(noisy).error;
    return pass;
  };
  ASSERT_FALSE(schedule.Next(found(16, 160)));
  EXPECT_EQ(schedule.State().end, 64u);
  ASSERT_FALSE(schedule.Next(found(1.1, 11)));
  EXPECT_EQ(schedule.State().end, 96u);
  ASSERT_FALSE(schedule.Next(found(2, 20)));
  EXPECT_EQ(schedule.State().end, 240u);
  // A filter that does not help is not waited for.
  ASSERT_FALSE(schedule.Next(found(2, 1.05)));
  EXPECT_EQ(schedule.State().end, 288u);
}

// Errors of filtered blocks are differences of squares.
TEST(Schedule, BlocksWhoseErrorIsEstimatedBelow0CountAs0) {
  RenderSettings settings = ToErrorOne();
  settings.denoise = true;
  for (const double elsewhere : {0.0, -0.5}) {
    Schedule schedule = Deciding(settings);
    PassOutcome pass = FoundInCorner(64, elsewhere);
    pass.noisy = FoundInCorner(640, 0.001).error;
    ASSERT_FALSE(schedule.Next(pass));
    EXPECT_EQ(schedule.State().targets.samples.front(), schedule.State().end);
    EXPECT_EQ(schedule.State().targets.samples.back(), 8u);
  }
}

// The filter's own estimate of a block may be small by chance.
TEST(Schedule, NoBlockCountsAsBetterFilteredThanTheImage) {
  RenderSettings settings = ToErrorOne();
  settings.denoise = true;
  for (const double noise : {0.001, 640.0}) {
    Schedule schedule = Deciding(settings);
    PassOutcome pass = FoundInCorner(64, 0);
    pass.noisy = FoundInCorner(640, noise).error;
    ASSERT_FALSE(schedule.Next(pass));
    EXPECT_EQ(schedule.State().targets.samples.back() > 8, noise > 1) << noise;
  }
}

}  // namespace
}  // namespace ray

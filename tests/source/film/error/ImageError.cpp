#include "source/film/error/ImageError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "source/film/error/FQuantile.h"
#include "source/sample/Random.h"
#include "tests/Draw.h"
#include "tests/source/film/TwoPartFilm.h"

namespace ray {
namespace {

constexpr std::array units{ErrorUnit::display, ErrorUnit::relative, ErrorUnit::decibel, ErrorUnit::linear};

/// Returns a film whose samples are 0.5 plus noise of a known deviation, in two independent parts of a and b samples
/// per pixel.
Film Noisy(int side, std::uint32_t a, std::uint32_t b, double deviation, std::uint64_t seed,
           FilterKind filter = FilterKind::box) {
  return TwoPartFilm(side, {a, b}, filter, [&](int part, int x, int y, std::uint32_t k) {
    const RandomKey key = RandomKey(seed)
                              .Child(static_cast<std::uint64_t>(x))
                              .Child(static_cast<std::uint64_t>(y))
                              .Child(2 * k + static_cast<std::uint32_t>(part));
    // Even over an interval, whose deviation is its length over the root of 12.
    const auto channel = [&](std::uint64_t which) {
      return 0.5 + std::sqrt(12.0) * deviation * (key.Child(which).Number() - 0.5);
    };
    return FilmSample{{channel(1), channel(2), channel(3)}, key.Child(5).Number(), key.Child(6).Number()};
  });
}

TEST(ImageError, IsTrueOnAverageForIndependentParts) {
  // The mean of a + b samples of deviation s has the deviation s / sqrt(a + b); the estimate of its square is unbiased
  // for any shares of the parts.
  for (const auto& [a, b] : {std::pair{4u, 4u}, {1u, 1u}, {6u, 2u}, {1u, 7u}}) {
    double sum = 0, squares = 0;
    constexpr int trials = 40;
    for (int i = 0; i < trials; ++i) {
      const auto measured = MeasureError(Noisy(32, a, b, 0.1, static_cast<std::uint64_t>(i)), {});
      ASSERT_TRUE(measured);
      sum += measured->square / trials;
      squares += measured->square * measured->square / trials;
    }
    const double truth = 0.01 / (a + b), deviation = std::sqrt((squares - sum * sum) / trials);
    EXPECT_NEAR(sum, truth, 4 * deviation) << a << ' ' << b;
    EXPECT_LT(deviation, 0.01 * truth);
  }
}

TEST(ImageError, IsReportedInEveryUnit) {
  const Film film = Noisy(64, 8, 8, 0.1, 3);
  const double truth = 0.1 / 4;  // 16 samples
  const auto estimate = [&](ErrorUnit unit) { return MeasureError(film, {.unit = unit})->estimate.estimate; };
  EXPECT_NEAR(estimate(ErrorUnit::linear), truth, 0.02 * truth);
  EXPECT_NEAR(estimate(ErrorUnit::display), 255 * truth, 0.02 * 255 * truth);
  EXPECT_NEAR(estimate(ErrorUnit::relative), 100 * truth / 0.5, 0.02 * 100 * truth / 0.5);
  EXPECT_NEAR(estimate(ErrorUnit::decibel), -20 * std::log10(truth), 0.2);
  // In an encoded image the same noise about 0.5 is smaller: the curve's slope there is d(1.055 x^(1/2.4)) / dx.
  const double slope = 1.055 / 2.4 * std::pow(0.5, 1 / 2.4 - 1);
  EXPECT_NEAR(MeasureError(film, {.srgb = true})->estimate.estimate, 255 * truth * slope, 0.03 * 255 * truth * slope);
  for (const ErrorUnit unit : units) {
    const auto measured = MeasureError(film, {.unit = unit});
    const ErrorEstimate& e = measured->estimate;
    EXPECT_EQ(e.unit, unit);
    const bool is_more_better = unit == ErrorUnit::decibel;
    EXPECT_TRUE(is_more_better ? e.low > e.estimate : e.low < e.estimate) << ErrorUnitName(unit);
    EXPECT_TRUE(is_more_better ? e.high < e.estimate : e.high > e.estimate) << ErrorUnitName(unit);
    // A target at the estimate is reached by the estimate and missed by the interval's end.
    const double square = SquaredTarget(e.estimate, {.unit = unit}, measured->mean);
    EXPECT_NEAR(square, measured->square, 1e-9 * square) << ErrorUnitName(unit);
    EXPECT_GT(measured->square_high, square) << ErrorUnitName(unit);
  }
}

/// Evaluates the chi-square distribution of one degree, which is F with very many in the denominator.
double NormalQuantile(double p) { return std::sqrt(FQuantile(2 * p - 1, 1, 1e6)); }

/// Returns the mean squared error of an image whose truth is 0.5.
double TrueSquare(const Film& film) {
  const R2::Image image = film.Image();
  double squares = 0;
  for (const float channel : image.Channels()) squares += (channel - 0.5) * (channel - 0.5);
  return squares / static_cast<double>(image.Channels().size());
}

TEST(ImageError, TheIntervalContainsTheErrorAsOftenAsStated) {
  for (const double confidence : {0.8, 0.95})
    for (const int side : {8, 32}) {
      int held = 0;
      double freedom = 0;
      const int trials = Count(1000, 20000);
      for (int i = 0; i < trials; ++i) {
        // Eight samples of each part are nearly normal.
        const Film film = Noisy(side, 8, 8, 0.1, 1000 + static_cast<std::uint64_t>(i));
        const auto measured = MeasureError(film, {.unit = ErrorUnit::linear, .confidence = confidence});
        const double truth = std::sqrt(TrueSquare(film));
        held += measured->estimate.low <= truth && truth <= measured->estimate.high;
        freedom += measured->estimate.freedom / trials;
      }
      // The interval is made for noise with longer tails than this, which is normal: the logarithm of the ratio has
      // less variance than the interval assumes.
      const double inner = std::sqrt(1.4 + 30 / freedom) * NormalQuantile((1 + confidence) / 2);
      const double expected = std::erf(inner / std::numbers::sqrt2);
      const double share = static_cast<double>(held) / trials, noise = std::sqrt(expected * (1 - expected) / trials);
      EXPECT_NEAR(share, expected, 4 * noise + 0.01) << confidence << ", side " << side;
    }
}

TEST(ImageError, AWideFilterIsMeasuredToo) {
  // Neighbors share samples, and the image is smoother; the estimate must agree with two images.
  for (const FilterKind filter : {FilterKind::gaussian, FilterKind::mitchell, FilterKind::lanczos}) {
    double claimed = 0, shown = 0;
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Film film = Noisy(48, 4, 4, 0.1, 2 * i, filter);
      claimed += MeasureError(film, {.unit = ErrorUnit::linear})->square;
      shown += TrueSquare(film);
    }
    // Each half is divided by its own weights, which with negative lobes and few samples differ more than those of all
    // samples. The estimate is then too high (measured: 1.18 for lanczos at 4 + 4 samples at random places), never too
    // low.
    EXPECT_GT(claimed / shown, 0.95) << filter_names[static_cast<std::size_t>(filter)];
    EXPECT_LT(claimed / shown, 1.25) << filter_names[static_cast<std::size_t>(filter)];
  }
}

TEST(ImageError, NothingIsKnownBeforeBothPartsHaveSamples) {
  Film film(8, 8, {0, 0, 8, 8}, FilterKind::box);
  EXPECT_FALSE(MeasureError(film, {}));
  film[0].sums[0] = film.EmptySums(0);
  film[0].samples[0] = 1;
  EXPECT_FALSE(MeasureError(film, {}));
}

TEST(ImageError, DegreesOfFreedomAreTheIndependentChannelsOfItsPixels) {
  const double channels = 3 * 32 * 32;
  EXPECT_NEAR(MeasureError(Noisy(32, 8, 8, 0.1, 1), {.unit = ErrorUnit::linear})->estimate.freedom, channels,
              0.1 * channels);
}

/// Returns a film with equal channels, with noise in every `every`th pixel.
Film GrayNoise(int side, int every, double deviation, std::uint64_t seed) {
  return TwoPartFilm(side, {1, 1}, FilterKind::box, [&](int part, int x, int y, std::uint32_t) {
    const RandomKey key = RandomKey(seed).Child(static_cast<std::uint64_t>(y * side + x));
    const double noise = (y * side + x) % every == 0 ? key.Child(static_cast<std::uint64_t>(part)).Number() : 0;
    return FilmSample{(0.5 + deviation * noise) * R2::Color{1, 1, 1}};
  });
}

TEST(ImageError, EqualChannelsCountOnceAndNoiselessPixelsNever) {
  const auto freedom = [](int every) {
    return MeasureError(GrayNoise(64, every, 0.1, 7), {.unit = ErrorUnit::linear})->estimate.freedom;
  };
  // Differences of uniform variables: the mean of their squares is 1 / 6, of their fourth powers 1 / 15, not 3 / 36 as
  // for normal ones.
  const double thin_tails = (3.0 / 36) / (1.0 / 15);
  EXPECT_NEAR(freedom(1), thin_tails * 64 * 64, 0.1 * 64 * 64);
  EXPECT_NEAR(freedom(64), thin_tails * 64, 0.3 * 64);
}

TEST(ImageError, FewPixelsGiveAWideInterval) {
  const ErrorMeasure measure{.unit = ErrorUnit::linear};
  const auto ratio = [&](int every) {
    const auto measured = MeasureError(GrayNoise(64, every, 0.1, 7), measure);
    return measured->estimate.high / measured->estimate.estimate;
  };
  EXPECT_LT(ratio(1), 1.08);
  EXPECT_GT(ratio(512), 1.5);
}

// Clamped, 7 and 7 in the two parts are 1 and 1, and so is their mean; 0.2 and 3 are 0.6 on average, and 1 together.
TEST(ImageError, ClampingCountsAsErrorOnlyWhereItHidesNoise) {
  const auto film_of = [](double a, double b) {
    return TwoPartFilm(8, {1, 1}, FilterKind::box, [&](int part, int, int, std::uint32_t) {
      return FilmSample{(part == 0 ? a : b) * R2::Color{1, 1, 1}};
    });
  };
  EXPECT_EQ(MeasureError(film_of(7, 7), {})->square, 0);
  EXPECT_EQ(MeasureError(film_of(1.5, 1.9), {})->square, 0) << "brighter than the difference of the parts explains";
  EXPECT_EQ(MeasureError(film_of(1.1, 2.3), {})->square, 0) << "no pixel can show more";
  const double difference = 0.8 / 2, bias = 0.6 - 1;
  EXPECT_NEAR(MeasureError(film_of(0.2, 3), {})->square, difference * difference + bias * bias, 1e-6);
  EXPECT_NEAR(MeasureError(film_of(0.2, 3), {.unit = ErrorUnit::linear})->square, 1.4 * 1.4, 1e-6);
}

// A pixel of a dark block is bright in one of the parts only.
TEST(ImageError, ClampedLightMayBelongToItsBlockOrARim) {
  const auto square = [](double found, double steady) {
    const Film film = TwoPartFilm(8, {1, 1}, FilterKind::box, [&](int part, int x, int y, std::uint32_t) {
      const double light = x + y == 0 ? part * found : x + y == 14 ? steady : 0;
      return FilmSample{light * R2::Color{1, 1, 1}};
    });
    return MeasureError(film, {})->square;
  };
  const double itself = 0.5;  // a quarter for the difference, and one for the bias of clamping
  const double cut_in_all = (10.0 - 1) / 64;
  EXPECT_NEAR(square(20, 0), (63 * cut_in_all * cut_in_all + itself) / 64, 1e-6) << "an equal part for each pixel";
  for (const double found : {1e3, 1e6, 1e30}) {
    EXPECT_NEAR(square(found, 0), (63 + itself) / 64, 1e-6) << "no pixel shows more than 1";
    EXPECT_NEAR(square(found, 5), (1 + itself) / 64, 1e-6) << "beside what is bright in both, one pixel more";
  }
}

TEST(ImageError, AnErrorThatDoesNotFallCountsAsLarger) {
  const Film film = Noisy(32, 4, 4, 0.1, 3);
  const ErrorMeasure measure{.unit = ErrorUnit::linear};
  const auto alone = MeasureError(film, measure);
  const auto after = [&](double factor, std::uint32_t samples) {
    BlockErrors before = alone->differences;
    for (double& square : before.squares) square *= factor;
    for (std::uint32_t& count : before.samples) count = samples;
    return MeasureError(film, measure, &before)->square / alone->square;
  };
  EXPECT_DOUBLE_EQ(after(2, 4), 1) << "it fell as it should";
  EXPECT_DOUBLE_EQ(after(4, 4), 1) << "and faster";
  EXPECT_NEAR(after(1, 4), 2, 1e-9) << "not at all, with twice the samples";
  EXPECT_NEAR(after(0.1, 4), 4, 1e-9) << "it rose";
  EXPECT_DOUBLE_EQ(after(0.1, 8), 1) << "no samples came";
}

TEST(ImageError, ASuddenlyVanishedErrorIsPartlyKept) {
  const Film film = Noisy(32, 4, 4, 0.1, 3);  // 8 samples per pixel
  const ErrorMeasure measure{.unit = ErrorUnit::linear};
  const auto alone = MeasureError(film, measure);
  BlockErrors before = alone->differences;
  for (std::uint32_t& count : before.samples) count = 4;
  before.squares[0] = 1;
  const auto after = MeasureError(film, measure, &before);
  EXPECT_DOUBLE_EQ(after->differences.squares[0], 1.0 / 8) << "an eighth of the square, with twice the samples";
  EXPECT_EQ(after->differences.squares[1], alone->differences.squares[1]);
}

TEST(ImageError, TheWorstBlockAndTheOutliersAreFound) {
  Film film = Noisy(32, 2, 2, 0.01, 5);
  const int worst = film.BlockOf(20, 12);
  film[worst].sums[0].Add(20, 12, 20.5, 12.5, {100, 100, 100}, film.filter());
  const auto e = MeasureError(film, {.unit = ErrorUnit::linear})->estimate;
  EXPECT_EQ(e.worst_block_at, (PixelRectangle{16, 8, 24, 16}));
  EXPECT_GT(e.worst_block, e.estimate);
  EXPECT_GT(e.outlier_share, 0.99);  // two of 1024 pixels are the worst thousandth
  EXPECT_LT(MeasureError(Noisy(32, 2, 2, 0.01, 5), {.unit = ErrorUnit::linear})->estimate.outlier_share, 0.02);
}

TEST(ImageError, TheIntervalAllowsForLightThatNoSampleHasFound) {
  const double rule_of_three = std::log(40.0);  // 3.7 with both ends of a 95 % interval
  for (const ErrorUnit unit : {ErrorUnit::display, ErrorUnit::linear}) {
    const ErrorMeasure measure{.unit = unit};
    MeasuredError error = *MeasureError(Noisy(32, 2, 2, 0.01, 5), measure);
    const MeasuredError before = error;
    AllowFor({}, measure, error);
    EXPECT_EQ(error.estimate.high, before.estimate.high);
    EXPECT_EQ(error.estimate.unseen_share, 0);
    AllowFor({.most = 20, .samples = 4096}, measure, error);
    // All of it in pixels of maximum brightness: 1 on a screen, otherwise 20.
    const double brightest = unit == ErrorUnit::display ? 1 : 20;
    const double unseen = 20 * rule_of_three / 4096 * brightest;
    EXPECT_NEAR(error.square_high, before.square_high + unseen, 1e-12);
    EXPECT_NEAR(error.estimate.unseen_share, unseen / error.square_high, 1e-12);
    EXPECT_EQ(error.square, before.square);
    EXPECT_EQ(error.estimate.low, before.estimate.low);
    EXPECT_NEAR(error.estimate.high, (unit == ErrorUnit::display ? 255 : 1) * std::sqrt(error.square_high), 1e-9);
  }
}

TEST(ImageError, UndetectedLightIsNoBrighterThanAScreen) {
  MeasuredError error = *MeasureError(Noisy(32, 2, 2, 0.01, 5), {});
  const double before = error.square_high;
  AllowFor({.most = 1e9, .samples = 4096}, {}, error);
  EXPECT_NEAR(error.square_high, before + 1, 1e-12);
}

R2::Image Gray(int side, double value) {
  R2::Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) image.Set(x, y, {value, value, value});
  return image;
}

R2::Image WithNoise(const R2::Image& image, double deviation, std::uint64_t seed) {
  R2::Image noisy(image.Width(), image.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const RandomKey key = RandomKey(seed).Child(static_cast<std::uint64_t>(x)).Child(static_cast<std::uint64_t>(y));
      const auto noise = [&](std::uint64_t k) { return std::sqrt(12.0) * deviation * (key.Child(k).Number() - 0.5); };
      const R2::Color c = image.At(x, y);
      noisy.Set(x, y, {c.r + noise(1), c.g + noise(2), c.b + noise(3)});
    }
  return noisy;
}

TEST(TrueError, OfAConstantOffsetIsThatOffset) {
  const R2::Image reference = Gray(8, 0.5), image = Gray(8, 0.625);
  EXPECT_DOUBLE_EQ(TrueError(image, reference, nullptr, {.unit = ErrorUnit::linear}), 0.125);
  EXPECT_DOUBLE_EQ(TrueError(image, reference, nullptr, {.unit = ErrorUnit::display}), 255 * 0.125);
  EXPECT_DOUBLE_EQ(TrueError(image, reference, nullptr, {.unit = ErrorUnit::relative}), 25);
  EXPECT_DOUBLE_EQ(TrueError(image, reference, nullptr, {.unit = ErrorUnit::decibel}), -20 * std::log10(0.125));
  // A screen clamps values above 1.
  EXPECT_EQ(TrueError(Gray(8, 7), Gray(8, 1), nullptr, {.unit = ErrorUnit::display}), 0);
  EXPECT_EQ(TrueError(reference, reference, nullptr, {.unit = ErrorUnit::linear}), 0);
  EXPECT_EQ(TrueError(reference, reference, nullptr, {.unit = ErrorUnit::decibel}), HUGE_VAL);
}

TEST(TrueError, TwoNoisyReferencesRevealTheErrorOneHides) {
  const R2::Image truth = Gray(128, 0.5), image = WithNoise(truth, 0.02, 1);
  const R2::Image one = WithNoise(truth, 0.03, 2), two = WithNoise(truth, 0.03, 3);
  const ErrorMeasure linear{.unit = ErrorUnit::linear};
  EXPECT_NEAR(TrueError(image, one, nullptr, linear), std::hypot(0.02, 0.03), 0.001);
  EXPECT_NEAR(TrueError(image, one, &two, linear), 0.02, 0.001);
  // Below the noise of the references the product may be negative; the error is then 0, not NaN.
  EXPECT_GE(TrueError(truth, one, &two, linear), 0);
}

TEST(ErrorText, ContainsTheNumberAndItsUnit) {
  EXPECT_EQ(ErrorText(1.25, ErrorUnit::display), "1.25/255");
  EXPECT_EQ(ErrorText(3.1, ErrorUnit::relative), "3.1%");
  EXPECT_EQ(ErrorText(42, ErrorUnit::decibel), "42 dB");
  EXPECT_EQ(ErrorText(0.002, ErrorUnit::linear), "0.002 lin");
}

TEST(ErrorUnits, LessErrorIsMoreDecibelsAndLessOfAllOthers) {
  const R2::Image reference = Gray(4, 0.5);
  for (const ErrorUnit unit : units) {
    const ErrorMeasure measure{.unit = unit};
    double last = TrueError(Gray(4, 1), reference, nullptr, measure), last_target = SquaredTarget(60, measure, 0.5);
    for (const double value : {0.9, 0.75, 0.6, 0.51, 0.5001}) {
      const double error = TrueError(Gray(4, value), reference, nullptr, measure);
      EXPECT_TRUE(unit == ErrorUnit::decibel ? error > last : error < last) << ErrorUnitName(unit) << ' ' << value;
      last = error;
    }
    for (const double target : {40.0, 20.0, 1.0}) {
      const double square = SquaredTarget(target, measure, 0.5);
      EXPECT_TRUE(unit == ErrorUnit::decibel ? square > last_target : square < last_target) << ErrorUnitName(unit);
      last_target = square;
    }
  }
}

}  // namespace
}  // namespace ray

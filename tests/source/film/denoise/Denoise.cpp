#include "source/film/denoise/Denoise.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <functional>
#include <limits>

#include "source/film/denoise/DenoisedError.h"
#include "source/sample/Random.h"
#include "tests/source/film/TwoPartFilm.h"

namespace ray {
namespace {

constexpr int side = 48;
constexpr double deviation = 0.05;  // of one stream

/// The inputs of images: the truth, and a guide that may contain it.
struct Subject {
  std::function<double(int, int)> truth = [](int, int) { return 0.5; };
  std::function<double(int, int)> guide = [](int, int) { return 0.0; };
};

/// One stream: the truth with even noise of that deviation.
R2::Image Stream(const Subject& subject, std::uint64_t seed, double noise = deviation) {
  R2::Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const RandomKey key = RandomKey(seed).Child(static_cast<std::uint64_t>(x)).Child(static_cast<std::uint64_t>(y));
      const auto channel = [&](std::uint64_t k) {
        return subject.truth(x, y) + std::sqrt(12.0) * noise * (key.Child(k).Number() - 0.5);
      };
      image.Set(x, y, {channel(0), channel(1), channel(2)});
    }
  return image;
}

Guides GuidesOf(const Subject& subject) {
  Guides guides;
  guides.best[0] = Pixels<PixelGuide>(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) guides.best[0].At(x, y)[3] = static_cast<float>(subject.guide(x, y));
  guides.of_stream[0] = guides.of_stream[1] = guides.best[1] = guides.best[0];
  return guides;
}

DenoisedImage Denoised(const Subject& subject, std::uint64_t seed) {
  return Denoise(Stream(subject, 2 * seed), Stream(subject, 2 * seed + 1), GuidesOf(subject));
}

double RmsError(const R2::Image& image, const Subject& subject) {
  double sum = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const R2::Color c = image.At(x, y);
      for (const double channel : {c.r, c.g, c.b}) sum += std::pow(channel - subject.truth(x, y), 2);
    }
  return std::sqrt(sum / (3.0 * side * side));
}

/// A film whose parts are these streams, one sample each.
Film FilmOf(const R2::Image& a, const R2::Image& b) {
  return TwoPartFilm(side, {1, 1}, FilterKind::box,
                     [&](int part, int x, int y, std::uint32_t) { return FilmSample{(part == 0 ? a : b).At(x, y)}; });
}

TEST(Denoise, AConstantImageIsUnchangedBitForBit) {
  const Subject gray;
  const R2::Image image = Stream(gray, 1, 0);
  EXPECT_TRUE(Denoise(image, image, GuidesOf(gray)).Mean() == image);
}

// A plane fitted to a whole window has the mean of its 49 pixels in the middle, so a seventh of the deviation is the
// optimum. Weights that mistake noise for differences leave more; the mean of two streams has 1 / sqrt(2) of one's.
TEST(Denoise, NoiseOnFlatSurfacesFallsAlmostToASeventh) {
  const Subject gray;
  const double before = deviation / std::sqrt(2.0), after = RmsError(Denoised(gray, 1).Mean(), gray);
  EXPECT_GT(after, before / 7);
  EXPECT_LT(after, before / 4);
}

TEST(Denoise, AGuidedEdgeStaysSharp) {
  const auto step = [](int x, int) { return x < side / 2 ? 0.3 : 0.7; };
  const Subject edge{step, step};
  const R2::Image image = Denoised(edge, 2).Mean();
  for (int y = 0; y < side; ++y)
    for (const int x : {side / 2 - 1, side / 2})
      EXPECT_NEAR(image.At(x, y).g, step(x, y), 2 * deviation) << x << ' ' << y;
  EXPECT_LT(RmsError(image, edge), deviation / std::sqrt(2.0) / 3);
}

TEST(Denoise, AGuidedTextureIsNotBlurred) {
  const auto squares = [](int x, int y) { return (x / 2 + y / 2) % 2 == 0 ? 0.4 : 0.6; };
  const Subject texture{squares, squares};
  EXPECT_LT(RmsError(Denoised(texture, 3).Mean(), texture), deviation / std::sqrt(2.0) / 3);
}

TEST(Denoise, AnUnguidedTextureGetsNoWorseThanItsNoise) {
  const auto squares = [](int x, int y) { return (x + y) % 2 == 0 ? 0.4 : 0.6; };
  const Subject texture{squares, [](int, int) { return 0.0; }};
  EXPECT_LT(RmsError(Denoised(texture, 4).Mean(), texture), deviation / std::sqrt(2.0));
}

// Features that camera rays alone determine are as accurate as the best guides, however much the streams differ.
TEST(Denoise, NoiseThatGuidesShareIsRemovedWithTheirs) {
  const Subject gray;
  const R2::Image a = Stream(gray, 5), b = Stream(gray, 6);
  Guides guides = GuidesOf({.guide = gray.truth});
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto channel = [&](const R2::Color& c) { return static_cast<float>(k == 0 ? c.r : k == 1 ? c.g : c.b); };
        guides.of_stream[0].At(x, y)[k] = channel(a.At(x, y));
        guides.of_stream[1].At(x, y)[k] = channel(b.At(x, y));
        guides.best[0].At(x, y)[k] = guides.best[1].At(x, y)[k] = 0.5F;
      }
  EXPECT_LT(RmsError(Denoise(a, b, guides).Mean(), gray), deviation / std::sqrt(2.0) / 10);
}

TEST(Denoise, OneBrightSampleAmongDarkOnesDoesNotSpread) {
  const Subject gray;
  R2::Image a = Stream(gray, 7);
  const R2::Image b = Stream(gray, 8);
  a.Set(20, 20, {1e6, 1e6, 1e6});
  const R2::Image image = Denoise(a, b, GuidesOf(gray)).Mean();
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const bool is_near = std::abs(x - 20) <= 3 && std::abs(y - 20) <= 3;
      EXPECT_TRUE(is_near || std::abs(image.At(x, y).r - 0.5) < 4 * deviation) << x << ' ' << y;
    }
}

TEST(Denoise, NonFiniteInputGivesFiniteOutput) {
  const Subject gray;
  R2::Image a = Stream(gray, 9), b = Stream(gray, 10);
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  a.Set(5, 5, {nan, infinity, -infinity});
  b.Set(5, 6, {infinity, nan, 3e38});
  b.Set(40, 0, {-3e38, 3e38, nan});
  const DenoisedImage denoised = Denoise(a, b, GuidesOf(gray));
  for (const R2::Image& image : {denoised.of_stream[0], denoised.of_stream[1], denoised.Mean()})
    for (const float channel : image.Channels()) ASSERT_TRUE(std::isfinite(channel));
}

TEST(Denoise, ImagesSmallerThanAWindowAreFilteredToo) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 5}, {3, 3}}) {
    R2::Image a(width, height), b(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) a.Set(x, y, {0.1 * x, 0.1, 0.2}), b.Set(x, y, {0.1, 0.1 * y, 0.3});
    Guides guides;
    for (auto* set : {guides.of_stream, guides.best}) set[0] = set[1] = Pixels<PixelGuide>(width, height);
    const R2::Image image = Denoise(a, b, guides).Mean();
    for (const float channel : image.Channels()) EXPECT_TRUE(channel >= 0 && channel <= 0.5F);
  }
}

TEST(Denoise, IsBitIdenticalOnAnyNumberOfThreads) {
  const auto waves = [](int x, int y) { return 0.5 + 0.3 * std::sin(0.4 * x) * std::cos(0.3 * y); };
  const Subject subject{waves, waves};
  const auto with_threads = [&](int threads) {
    const tbb::global_control permission(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return Denoised(subject, 11).Mean(); });
  };
  const R2::Image one = with_threads(1);
  EXPECT_TRUE(one == with_threads(2));
  EXPECT_TRUE(one == with_threads(7));
}

// The estimate of a render is a single number; over many renders its square must be that of the truth.
TEST(DenoisedError, EstimatesAreTrueOnAverage) {
  const auto waves = [](int x, int y) {
    return 0.5 + 0.2 * std::sin(0.5 * x) * std::sin(0.4 * y) + (x > 30 ? 0.2 : 0);
  };
  for (const Subject& subject : {Subject{waves, waves}, Subject{waves, [](int, int) { return 0.0; }}}) {
    double claimed = 0, truth = 0;
    constexpr int trials = 20;
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
      const R2::Image a = Stream(subject, 2 * seed), b = Stream(subject, 2 * seed + 1);
      const DenoisedImage denoised = Denoise(a, b, GuidesOf(subject));
      claimed += MeasureDenoisedError(FilmOf(a, b), denoised, {}).square;
      truth += std::pow(RmsError(denoised.Mean(), subject), 2);
    }
    EXPECT_NEAR(std::sqrt(claimed / truth), 1, 0.1);
  }
}

// In noise a thousand times larger than the difference of the filtered streams, a bias of that size cannot be measured.
// A filter of optimal strength has half of its variance as its squared bias.
TEST(DenoisedError, HiddenBiasCountsAsHalfTheVariance) {
  const Subject gray;
  constexpr double step = 0.001;  // from one filtered stream to the other
  DenoisedImage denoised{{R2::Image(side, side), R2::Image(side, side)}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int i = 0; i < 2; ++i) {
        const double value = 0.5 + i * step;
        denoised.of_stream[i].Set(x, y, {value, value, value});
      }
  const Film film = FilmOf(Stream(gray, 12, 1000 * step), Stream(gray, 13, 1000 * step));
  const double square = MeasureDenoisedError(film, denoised, {.unit = ErrorUnit::linear}).square;
  constexpr double variance = step * step / 4;  // of the mean of both
  EXPECT_NEAR(square, 1.5 * variance, 0.05 * variance);
}

TEST(DenoisedError, AnImageWithoutNoiseHasNone) {
  const Subject gray;
  const R2::Image image = Stream(gray, 1, 0);
  const ErrorEstimate claim =
      MeasureDenoisedError(FilmOf(image, image), Denoise(image, image, GuidesOf(gray)), {}).estimate;
  EXPECT_EQ(claim.estimate, 0);
  EXPECT_EQ(claim.high, 0);
}

TEST(Pixels, MeansAroundAverageARingWithinTheImage) {
  Pixels<Rgb> values(9, 7);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 9; ++x) values.At(x, y) = {static_cast<float>(x * y), static_cast<float>(x), 1};
  const Pixels<Rgb> means = MeansAround(values, 3, 1);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 9; ++x) {
      double sum = 0;
      int count = 0;
      for (int j = y - 3; j <= y + 3; ++j)
        for (int i = x - 3; i <= x + 3; ++i)
          if (values.Contains(i, j) && std::max(std::abs(i - x), std::abs(j - y)) > 1) sum += i * j, ++count;
      EXPECT_NEAR(means.At(x, y)[0], sum / count, 1e-4);
      EXPECT_FLOAT_EQ(means.At(x, y)[2], 1);
    }
}

}  // namespace
}  // namespace ray

#include "source/render/forecast/FinishForecast.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/source/film/TwoPartFilm.h"

namespace ray {
namespace {

/// Returns a film in which each pixel has the color of its place.
Film Shaded(int side) {
  return TwoPartFilm(side, {1, 0}, FilterKind::box, [](int, int x, int y, std::uint32_t) {
    return FilmSample{{x / 1024.0, y / 1024.0, 0.5}};
  });
}

TEST(FinishForecast, WithoutLooksIsTheInitialEstimate) {
  FinishForecast forecast(3, {});
  forecast.Look(Shaded(16), R2::Quantization::rounded);
  EXPECT_EQ(forecast.Seconds(), 3);
}

TEST(FinishForecast, LooksAtSmallPartsAllOverTheImage) {
  std::int64_t looked_at = 0;
  double lowest = 1, highest = 0;
  FinishForecast forecast(3, [&](const R2::Image& parts) {
    looked_at += std::int64_t{parts.Width()} * parts.Height();
    EXPECT_NEAR(parts.At(parts.Width() - 1, 0).r - parts.At(0, 0).r, (parts.Width() - 1) / 1024.0, 1e-6);
    for (int y = 0; y < parts.Height(); ++y) {
      lowest = std::min(lowest, parts.At(0, y).g);
      highest = std::max(highest, parts.At(0, y).g);
    }
  });
  forecast.Look(Shaded(1024), R2::Quantization::rounded);
  EXPECT_LE(looked_at, 2 * 1024 * 1024 / 32) << "twice";
  EXPECT_GE(looked_at, 2 * 1024 * 1024 / 64);
  EXPECT_LT(lowest, 0.5);
  EXPECT_GT(highest, 0.5);
  EXPECT_NE(forecast.Seconds(), 3) << "what it was told before counts no more";
}

TEST(FinishForecast, ScalesWithTheNumberOfPixels) {
  using std::chrono::milliseconds;
  int attempts = 0;
  FinishForecast forecast(0, [&](const R2::Image& parts) {
    ++attempts;
    EXPECT_EQ(parts.Width() * parts.Height(), 2 * 128 * 128);
    std::this_thread::sleep_for(milliseconds(2));
  });
  forecast.Look(Shaded(1024), R2::Quantization::rounded);
  EXPECT_EQ(attempts, 2);
  EXPECT_GE(forecast.Seconds(), 32 * 0.002);
}

}  // namespace
}  // namespace ray

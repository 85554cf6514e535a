#include "source/film/denoise/Pixels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/sample/Random.h"

namespace ray {
namespace {

Pixels<Rgb> Noise(int width, int height) {
  Pixels<Rgb> pixels(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t k = 0; k < 3; ++k) {
        const RandomKey key = RandomKey(k).Child(static_cast<std::uint64_t>(1000 * y + x));
        pixels.At(x, y)[k] = static_cast<float>(std::exp(20 * key.Number() - 10));  // of many sizes
      }
  return pixels;
}

TEST(MeansAround, AreTheMeansOfASquareWithoutAnother) {
  const Pixels<Rgb> pixels = Noise(19, 13);
  for (const auto& [radius, hole] : {std::pair{3, 1}, {7, 3}, {6, -1}, {2, 0}, {30, 0}}) {
    const Pixels<Rgb> means = MeansAround(pixels, radius, hole);
    for (int y = 0; y < 13; ++y)
      for (int x = 0; x < 19; ++x) {
        double sum = 0, count = 0;
        for (int j = 0; j < 13; ++j)
          for (int i = 0; i < 19; ++i) {
            const int away = std::max(std::abs(i - x), std::abs(j - y));
            if (away > radius || away <= hole) continue;
            sum += pixels.At(i, j)[1];
            ++count;
          }
        EXPECT_NEAR(means.At(x, y)[1] / (sum / count), 1, 1e-6) << radius << ' ' << hole << ' ' << x << ' ' << y;
      }
  }
}

TEST(MeansAround, WithoutSurroundingsAreThePixelsThemselves) {
  const Pixels<Rgb> pixels = Noise(1, 1);
  EXPECT_EQ(MeansAround(pixels, 3, 1).At(0, 0), pixels.At(0, 0));
}

// A denoised crop must have the bits of the whole image.
TEST(MeansAround, OfAPartEqualThoseOfTheWhole) {
  const Pixels<Rgb> whole = Noise(60, 50);
  const int radius = 7, hole = 3;
  const Pixels<Rgb> means = MeansAround(whole, radius, hole);
  for (const auto& [x0, y0] : {std::pair{11, 5}, {1, 20}, {30, 0}}) {
    Pixels<Rgb> part(29, 30);
    for (int y = 0; y < part.Height(); ++y)
      for (int x = 0; x < part.Width(); ++x) part.At(x, y) = whole.At(x0 + x, y0 + y);
    const Pixels<Rgb> of_part = MeansAround(part, radius, hole);
    for (int y = radius; y < part.Height() - radius; ++y)
      for (int x = radius; x < part.Width() - radius; ++x)
        ASSERT_EQ(of_part.At(x, y), means.At(x0 + x, y0 + y)) << x << ' ' << y;
  }
}

}  // namespace
}  // namespace ray

#include "source/film/denoise/LocalFit.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <limits>
#include <vector>

#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/sample/Random.h"

namespace ray {
namespace {

constexpr std::size_t guide_count = std::tuple_size_v<PixelGuide>;

/// The inputs of a fit.
struct FitSubject {
  Pixels<Rgb> colors, compared, variance;
  Pixels<PixelGuide> guides, best;
  double strength = 1;

  FitSubject(int width, int height)
      : colors(width, height),
        compared(width, height),
        variance(width, height),
        guides(width, height),
        best(width, height) {}
  LocalFitInput Input() const { return {colors, guides, best, compared, variance, strength}; }
  Pixels<Rgb> Fitted() const {
    WorkMeter nobody;
    return LocalFit(Input(), nobody);
  }
};

/// Waves and edges under noise: colors up to 2, and guides that contain them, contain nothing, or are dependent.
FitSubject NoisyFit(int width, int height, double strength = 1) {
  FitSubject subject(width, height);
  subject.strength = strength;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const RandomKey key = RandomKey(7).Child(static_cast<std::uint64_t>(x)).Child(static_cast<std::uint64_t>(y));
      const double wave = std::sin(0.4 * x) * std::cos(0.3 * y), edge = x > y + 5 ? 1 : 0;
      const auto noise = [&](std::uint64_t i) { return 0.2 * (key.Child(i).Number() - 0.5); };
      for (std::size_t k = 0; k < 3; ++k) {
        subject.colors.At(x, y)[k] = static_cast<float>(1 + 0.3 * wave + 0.5 * edge + noise(k));
        subject.compared.At(x, y)[k] = subject.colors.At(x, y)[k];
        subject.variance.At(x, y)[k] = static_cast<float>(0.0033 * (1 + 0.5 * edge));
      }
      const PixelGuide guide{static_cast<float>(1 + edge),
                             static_cast<float>(wave),
                             0.25F,
                             static_cast<float>(edge),
                             static_cast<float>(edge),
                             static_cast<float>(noise(3)),
                             static_cast<float>(0.1 * x),
                             static_cast<float>(wave * edge),
                             0,
                             0};
      subject.best.At(x, y) = guide;
      for (std::size_t k = 0; k < guide_count; ++k)
        subject.guides.At(x, y)[k] = guide[k] + (k == 9 ? 0 : static_cast<float>(0.3 * noise(10 + k)));
    }
  return subject;
}

// The fit in plain double precision, pixel by pixel, by the equations; it shares no code with the tested one.
namespace plain {

double WeightOf(const FitSubject& s, int px, int py, int dx, int dy) {
  double distance = 0;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double difference =
            s.compared.Clamped(px + i, py + j)[k] - s.compared.Clamped(px + dx + i, py + dy + j)[k];
        const double p = s.variance.Clamped(px + i, py + j)[k], q = s.variance.Clamped(px + dx + i, py + dy + j)[k];
        distance += (difference * difference - p - std::min(p, q)) / (1e-7 + s.strength * s.strength * (p + q)) / 27;
      }
  const double weight = std::exp(-std::max(0.0, distance));
  return weight >= 1e-4 ? weight : 0;
}

/// Solves by Gauss and Jordan, with pivoting.
std::vector<double> Solution(std::vector<std::vector<double>> rows, std::vector<double> right) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(rows[i][k]) > std::abs(rows[best][k])) best = i;
    std::swap(rows[k], rows[best]), std::swap(right[k], right[best]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double share = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < n; ++j) rows[i][j] -= share * rows[k][j];
      right[i] -= share * right[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) right[k] /= rows[k][k];
  return right;
}

double Fitted(const FitSubject& s, int px, int py, std::size_t channel) {
  constexpr std::size_t unknowns = 3 + guide_count;
  std::vector<std::vector<double>> rows(unknowns, std::vector<double>(unknowns));
  std::vector<double> right(unknowns);
  double low = s.colors.At(px, py)[channel], high = low;
  for (int dy = -3; dy <= 3; ++dy)
    for (int dx = -3; dx <= 3; ++dx) {
      if (!s.colors.Contains(px + dx, py + dy)) continue;
      const double weight = WeightOf(s, px, py, dx, dy), color = s.colors.At(px + dx, py + dy)[channel];
      if (weight == 0) continue;
      std::vector<double> z{1, dx / 3.0, dy / 3.0};
      for (std::size_t k = 0; k < guide_count; ++k)
        z.push_back(double{s.guides.At(px + dx, py + dy)[k]} - s.best.At(px, py)[k]);
      for (std::size_t i = 0; i < unknowns; ++i) {
        for (std::size_t j = 0; j < unknowns; ++j) rows[i][j] += weight * z[i] * z[j];
        right[i] += weight * z[i] * color;
      }
      low = std::min(low, color), high = std::max(high, color);
    }
  const double total = rows[0][0];
  for (std::size_t i = 1; i < unknowns; ++i) rows[i][i] += 1e-5 * rows[i][i] + (i < 3 ? 0.1 : 5e-4) * total;
  return std::clamp(Solution(rows, right)[0], low, high);
}

}  // namespace plain

TEST(LocalFit, SolvesItsEquationsWithinFloatRounding) {
  for (const double strength : {1.0, 2.0})
    for (const auto& [width, height] : {std::pair{45, 21}, {3, 3}, {1, 1}, {2, 40}, {70, 1}}) {
      const FitSubject subject = NoisyFit(width, height, strength);
      const Pixels<Rgb> fitted = subject.Fitted();
      double most = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, std::abs(fitted.At(x, y)[k] - plain::Fitted(subject, x, y, k)));
      EXPECT_LT(most, 2e-5) << width << ' ' << height;
    }
}

/// Returns the fit of an image by one instruction set.
struct FitMaking {
  FitSubject subject;
  Pixels<Rgb> fitted;
};

TEST(LocalFit, IsBitIdenticalWithEveryInstructionSet) {
  const FitSubject subject = NoisyFit(75, 37);
  const Pixels<Rgb> best = subject.Fitted();
  for (const std::string& set : InstructionSets()) {
    FitMaking making{subject, {}};
    WithInstructionSet(
        set,
        [](void* made) { static_cast<FitMaking*>(made)->fitted = static_cast<FitMaking*>(made)->subject.Fitted(); },
        &making);
    EXPECT_TRUE(ImageOf(making.fitted) == ImageOf(best)) << set;
  }
}

TEST(LocalFit, NoBitDependsOnWhereTilesBegin) {
  const FitSubject whole = NoisyFit(90, 60);
  const Pixels<Rgb> of_whole = whole.Fitted();
  constexpr int margin = 4;  // pixels that a cut changes around it
  for (const auto& [x0, y0] : {std::pair{1, 0}, {0, 1}, {13, 7}, {31, 17}}) {
    FitSubject part(50, 40);
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 50; ++x) {
        part.colors.At(x, y) = whole.colors.At(x0 + x, y0 + y);
        part.compared.At(x, y) = whole.compared.At(x0 + x, y0 + y);
        part.variance.At(x, y) = whole.variance.At(x0 + x, y0 + y);
        part.guides.At(x, y) = whole.guides.At(x0 + x, y0 + y);
        part.best.At(x, y) = whole.best.At(x0 + x, y0 + y);
      }
    const Pixels<Rgb> of_part = part.Fitted();
    for (int y = margin; y < 40 - margin; ++y)
      for (int x = margin; x < 50 - margin; ++x)
        ASSERT_EQ(of_part.At(x, y), of_whole.At(x0 + x, y0 + y)) << x0 << ' ' << y0 << ": " << x << ' ' << y;
  }
}

// Guides may be very bright light, and sums of its squares leave few digits for others in a float.
TEST(LocalFit, GuidesOfAnySizeKeepColorsInTheirNeighborsRange) {
  constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const float size : {1e3F, 1e6F, 1e18F, 3e38F, infinity, nan}) {
    FitSubject subject = NoisyFit(40, 24);
    for (int y = 5; y < 20; y += 3)
      for (int x = 3; x < 40; x += 4) {
        subject.guides.At(x, y)[0] = subject.guides.At(x, y)[1] = size;
        subject.best.At(x + 1 < 40 ? x + 1 : x, y)[1] = -size;
      }
    const Pixels<Rgb> fitted = subject.Fitted();
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 40; ++x)
        for (const float channel : fitted.At(x, y)) ASSERT_TRUE(channel > 0.5F && channel < 2) << size;
  }
}

TEST(LocalFit, BrightGuidesThatMatchTheColorLeaveItUnchanged) {
  for (const double scale : {1.0, 100.0, 1e4}) {
    FitSubject subject(40, 24);
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 40; ++x)
        for (std::size_t k = 0; k < 3; ++k) {
          const auto light =
              static_cast<float>(scale * (1 + std::sin(0.7 * x + static_cast<double>(k)) * std::cos(0.9 * y)));
          subject.colors.At(x, y)[k] = subject.guides.At(x, y)[k] = subject.best.At(x, y)[k] = light;
          subject.variance.At(x, y)[k] = 1;  // of `compared`, which is the same everywhere
        }
    const Pixels<Rgb> fitted = subject.Fitted();
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 40; ++x)
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_NEAR(fitted.At(x, y)[k], subject.colors.At(x, y)[k], 0.01 * scale) << scale;
  }
}

}  // namespace
}  // namespace ray

#include "source/film/denoise/LocalFit.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "R1/Elementary.h"
#include "source/film/denoise/Regression.h"

namespace ray {
namespace {

// On the scenes of script/denoise_table.sh windows of 11 x 11 pixels had 3 % more error for twice the time, patches of
// 5 x 5 had 3 % less but made claims less true: noise that a pixel is compared by must not be its own.
constexpr int window = 3;                // pixels to each side that a fit looks at
constexpr int patch = 1;                 // pixels to each side that surroundings are compared by
constexpr int side = 16;                 // of a tile; changes no bit
constexpr float least_variance = 1e-7F;  // a deviation of 0.08 255ths, which nobody sees
constexpr double least_weight = 1e-4;    // of a neighbor; what all less than this hold is below 1 % of the pixel's own

// How much a change of 1 in a regressor must explain, per unit of weight, to be believed by half: guides change by up
// to about 1 over an edge, places by 1 from the middle of a window to its rim. From 1e-2 down to 5e-4 the error fell by
// a tenth; 0.1 for places had 1 % less error than 0.01.
constexpr double ridge_of_guides = 5e-4, ridge_of_places = 0.1;

constexpr std::size_t guide_count = std::tuple_size_v<PixelGuide>, unknowns = 1 + guide_count + 2;
using Fit = Regression<unknowns>;

Fit::Regressors Ridge() {
  Fit::Regressors ridge;
  ridge.fill(ridge_of_guides);
  ridge[0] = 0;
  ridge[unknowns - 2] = ridge[unknowns - 1] = ridge_of_places;
  return ridge;
}

constexpr int TilesAcross(int pixels) { return (pixels + side - 1) / side; }

/// A pixel's fit while its neighbors are added.
struct PixelFit {
  Fit fit;
  Rgb low, high;
};

/// The fits of a square of pixels.
class Tile {
 public:
  Tile(const LocalFitInput& input, int x0, int y0)
      : input_(input),
        x0_(x0),
        y0_(y0),
        width_(std::min(side, input.colors.Width() - x0)),
        height_(std::min(side, input.colors.Height() - y0)),
        distances_(width_ + 2 * patch, height_ + 2 * patch),
        fits_(width_, height_) {}

  void WriteTo(Pixels<Rgb>& result) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const Rgb& own = input_.colors.At(x0_ + x, y0_ + y);
        fits_.At(x, y) = {{}, own, own};
      }
    for (int dy = -window; dy <= window; ++dy)
      for (int dx = -window; dx <= window; ++dx) AddNeighbors(dx, dy);
    static const Fit::Regressors ridge = Ridge();
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const PixelFit& pixel = fits_.At(x, y);
        const Fit::Channels fitted = pixel.fit.Intercepts(ridge);
        for (std::size_t k = 0; k < 3; ++k)
          result.At(x0_ + x, y0_ + y)[k] = std::clamp(static_cast<float>(fitted[k]), pixel.low[k], pixel.high[k]);
      }
  }

 private:
  /// All pairs of pixels that are dx, dy apart.
  void AddNeighbors(int dx, int dy) {
    for (int y = 0; y < distances_.Height(); ++y)
      for (int x = 0; x < distances_.Width(); ++x) {
        const int px = x0_ + x - patch, py = y0_ + y - patch;
        distances_.At(x, y) = Distance(px, py, px + dx, py + dy);
      }
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        if (!input_.colors.Contains(x0_ + x + dx, y0_ + y + dy)) continue;
        float sum = 0;
        for (int j = 0; j <= 2 * patch; ++j)
          for (int i = 0; i <= 2 * patch; ++i) sum += distances_.At(x + i, y + j);
        constexpr float pixels = (2 * patch + 1) * (2 * patch + 1);
        const double weight = R1::Exp(-std::max(0.0F, sum / pixels));
        if (weight >= least_weight) AddNeighbor(x, y, dx, dy, weight);
      }
  }

  /// Of two pixels, squared: 0 on average where only noise tells them apart, 1 / strength^2 where their difference is
  /// as large as that.
  float Distance(int px, int py, int qx, int qy) const {
    const Rgb &p = input_.compared.Clamped(px, py), &q = input_.compared.Clamped(qx, qy);
    const Rgb &p_variance = input_.variance.Clamped(px, py), &q_variance = input_.variance.Clamped(qx, qy);
    const auto strength_squared = static_cast<float>(input_.strength * input_.strength);
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float difference = p[k] - q[k];
      const float noise = p_variance[k] + std::min(p_variance[k], q_variance[k]);
      sum += (difference * difference - noise) / (least_variance + strength_squared * (p_variance[k] + q_variance[k]));
    }
    return sum / 3;
  }

  void AddNeighbor(int x, int y, int dx, int dy, double weight) {
    PixelFit& pixel = fits_.At(x, y);
    const int qx = x0_ + x + dx, qy = y0_ + y + dy;
    const PixelGuide &best = input_.best.At(x0_ + x, y0_ + y), &guide = input_.guides.At(qx, qy);
    Fit::Regressors z;
    z[0] = 1;
    for (std::size_t k = 0; k < guide_count; ++k) z[1 + k] = guide[k] - best[k];
    z[unknowns - 2] = static_cast<double>(dx) / window;
    z[unknowns - 1] = static_cast<double>(dy) / window;
    const Rgb& color = input_.colors.At(qx, qy);
    pixel.fit.Add(weight, z, {color[0], color[1], color[2]});
    for (std::size_t k = 0; k < 3; ++k) {
      pixel.low[k] = std::min(pixel.low[k], color[k]);
      pixel.high[k] = std::max(pixel.high[k], color[k]);
    }
  }

  const LocalFitInput& input_;
  const int x0_, y0_, width_, height_;
  Pixels<float> distances_;  // of the tile's pixels and of `patch` around them
  Pixels<PixelFit> fits_;
};

}  // namespace

std::int64_t LocalFitTiles(int width, int height) { return std::int64_t{TilesAcross(width)} * TilesAcross(height); }

Pixels<Rgb> LocalFit(const LocalFitInput& input, WorkMeter& meter) {
  Pixels<Rgb> result(input.colors.Width(), input.colors.Height());
  const int columns = TilesAcross(result.Width()), rows = TilesAcross(result.Height());
  tbb::parallel_for(0, columns * rows, [&](int i) {
    if (meter.IsStopped()) return;
    Tile(input, i % columns * side, i / columns * side).WriteTo(result);
    meter.PartIsDone();
  });
  return result;
}

}  // namespace ray

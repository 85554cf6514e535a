#include "source/film/denoise/LocalFit.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <utility>

#include "R1/Targets.h"
#include "source/film/denoise/FitTile.h"

// Highway compiles this file once for each instruction set. Code that is independent of it is included before.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/film/denoise/LocalFit.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef RAY_FILM_DENOISE_LOCAL_FIT
#define RAY_FILM_DENOISE_LOCAL_FIT
namespace ray {

inline constexpr float least_variance = 1e-7F;  // a deviation of 0.08/255, which is invisible
// of a neighbor; all smaller weights sum to less than 1% of the pixel's own
inline constexpr float least_weight = 1e-4F;

// The change of color per unit of weight that a change of 1 in a regressor must explain to have half its full effect.
// Guides change by up to about 1 across an edge, places by 1 from the middle of a window to its rim. From 1e-2 down to
// 5e-4 the error fell by a tenth; 0.1 for places had 1% less error than 0.01.
inline constexpr float ridge_of_guides = 5e-4F, ridge_of_places = 0.1F;
// The share of a regressor's sum of squares that is added to it as a ridge. The relative error of sums of floats is
// about 1e-6, which is less. So, except for a last bit or two, the fit is that of a slightly different ridge.
//   source   Higham, Accuracy and Stability of Numerical Algorithms (2002), theorem 10.3
inline constexpr float ridge_of_rounding = 1e-5F;
inline constexpr float least_remainder = 1e-6F;  // of the sum of weights: less after elimination is rounding

/// The neighbors of a pixel of a tile, in rows.
struct Neighborhood {
  static constexpr int side = 2 * FitTile::window + 1;
  static constexpr std::size_t size = side * side;

  /// Returns the index of the neighbor at offset dx, dy.
  static constexpr std::size_t IndexOf(int dx, int dy) {
    return static_cast<std::size_t>((dy + FitTile::window) * side + dx + FitTile::window);
  }
};

/// Numbers in rows, each followed by the padding that a vector may read past its end.
template <int columns, int rows>
class FloatRows {
 public:
  float* At(int x, int y) { return values_.data() + IndexOf(x, y); }
  const float* At(int x, int y) const { return values_.data() + IndexOf(x, y); }

 private:
  static constexpr int pitch = columns + FitTile::most_lanes;
  static constexpr std::ptrdiff_t IndexOf(int x, int y) { return std::ptrdiff_t{y} * pitch + x; }

  alignas(64) std::array<float, std::size_t{pitch} * rows> values_{};
};

/// The working memory of a tile's fits.
struct FitWork {
  FitTile tile;
  std::array<FloatRows<FitTile::columns, FitTile::rows>, Neighborhood::size> weights;  // of each pixel
  // Distances of a row and one pixel more at either end, and their sums over three rows, including one row below and
  // one above.
  FloatRows<FitTile::columns + 2, 1> distances;
  FloatRows<FitTile::columns, FitTile::rows + 2> row_sums;
  FloatRows<FitTile::columns, 3> fitted;  // of a row, by channel
};

}  // namespace ray
#endif

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, FitTile::most_lanes>;
using Floats = hn::Vec<Lanes>;
constexpr int lanes = hn::MaxLanes(Lanes());

// Multiplication and addition are not fused, so every instruction set gives the same bits.
HWY_INLINE Floats MultiplyAndAdd(Floats a, Floats b, Floats c) { return hn::Add(hn::Mul(a, b), c); }

/// Returns exp(-x) for x >= 0, or 0 if that is below least_weight.
///   accuracy   relative error 3e-6, which is enough for a weight
///   source     2^whole from the exponent's bits; the rest from six terms of the series of exp within ln 2 / 2
HWY_INLINE Floats WeightOf(Floats x) {
  const Lanes d;
  const hn::RebindToSigned<Lanes> integers;
  constexpr float log2_e = 1.44269504F, ln_2 = 0.693147181F, most = 16;
  const Floats exponent = hn::Mul(hn::Min(x, hn::Set(d, most)), hn::Set(d, -log2_e));
  const Floats shifter = hn::Set(d, 0x1.8p23F);  // adding it leaves an integer in the last bits
  const Floats shifted = hn::Add(exponent, shifter);
  const Floats rest = hn::Mul(hn::Sub(exponent, hn::Sub(shifted, shifter)), hn::Set(d, ln_2));
  Floats sum = hn::Set(d, 1.0F / 120);
  for (const float coefficient : {1.0F / 24, 1.0F / 6, 1.0F / 2, 1.0F, 1.0F})
    sum = MultiplyAndAdd(sum, rest, hn::Set(d, coefficient));
  const auto whole = hn::ShiftLeft<23>(hn::BitCast(integers, shifted));
  const Floats weight = hn::BitCast(d, hn::Add(hn::BitCast(integers, sum), whole));
  return hn::IfThenElseZero(hn::Ge(weight, hn::Set(d, least_weight)), weight);
}

/// Returns three times the distance of pixels p and q: the mean of the result is over channels. It is 0 on average if
/// they differ by noise only, and 1 / strength^2 if their difference is as large as the noise.
HWY_INLINE Floats TripleDistance(const FitTile& tile, std::ptrdiff_t p, std::ptrdiff_t q) {
  const Lanes d;
  const Floats least = hn::Set(d, least_variance), strength_squared = hn::Set(d, tile.StrengthSquared());
  Floats sum = hn::Zero(d);
  for (std::size_t k = 0; k < 3; ++k) {
    const Floats p_variance = hn::LoadU(d, tile.variance[k].data() + p);
    const Floats q_variance = hn::LoadU(d, tile.variance[k].data() + q);
    const Floats difference =
        hn::Sub(hn::LoadU(d, tile.compared[k].data() + p), hn::LoadU(d, tile.compared[k].data() + q));
    const Floats noise = hn::Add(p_variance, hn::Min(p_variance, q_variance));
    const Floats scale = MultiplyAndAdd(strength_squared, hn::Add(p_variance, q_variance), least);
    sum = hn::Add(sum, hn::Div(hn::Sub(hn::Mul(difference, difference), noise), scale));
  }
  return sum;
}

/// Computes the weights of the neighbors at offset dx, dy from the tile's pixels.
void MakeWeights(FitWork& work, int dx, int dy) {
  static_assert(FitTile::patch == 1);
  const Lanes d;
  const FitTile& tile = work.tile;
  for (int y = -1; y <= tile.Rows(); ++y) {
    for (int x = -1; x <= tile.Columns(); x += lanes)
      hn::StoreU(TripleDistance(tile, FitTile::At(x, y), FitTile::At(x + dx, y + dy)), d, work.distances.At(x + 1, 0));
    for (int x = 0; x < tile.Columns(); x += lanes) {
      const float* distances = work.distances.At(x, 0);
      const Floats sum = hn::Add(hn::LoadU(d, distances), hn::LoadU(d, distances + 1));
      hn::StoreU(hn::Add(sum, hn::LoadU(d, distances + 2)), d, work.row_sums.At(x, y + 1));
    }
  }
  auto& weights = work.weights[Neighborhood::IndexOf(dx, dy)];
  for (int y = 0; y < tile.Rows(); ++y)
    for (int x = 0; x < tile.Columns(); x += lanes) {
      const Floats lower = hn::LoadU(d, work.row_sums.At(x, y)), own = hn::LoadU(d, work.row_sums.At(x, y + 1));
      const Floats sum = hn::Add(hn::Add(lower, own), hn::LoadU(d, work.row_sums.At(x, y + 2)));
      constexpr float parts = 3 * 9;  // channels of the pixels of a patch
      const Floats weight = WeightOf(hn::Max(hn::Zero(d), hn::Mul(sum, hn::Set(d, 1 / parts))));
      const Floats is_there = hn::LoadU(d, tile.HasColumn(x + dx));
      hn::StoreU(tile.HasRow(y + dy) ? hn::Mul(weight, is_there) : hn::Zero(d), d, weights.At(x, y));
    }
}

/// Fits one pixel per lane of a vector: weighted linear least squares of colors on places and on guides minus the
/// pixel's best guide.
class Fit {
 public:
  Fit(const FitWork& work, int x, int y) : tile_(work.tile), at_(FitTile::At(x, y)) {
    for (int dy = -FitTile::window; dy <= FitTile::window; ++dy)
      for (int dx = -FitTile::window; dx <= FitTile::window; ++dx) {
        const Floats weight = hn::LoadU(Lanes(), work.weights[Neighborhood::IndexOf(dx, dy)].At(x, y));
        if (!hn::AllTrue(Lanes(), hn::Eq(weight, hn::Zero(Lanes())))) AddNeighbor(dx, dy, weight);
      }
  }

  /// Writes the fitted pixels at x of the row, in three channels.
  void WriteTo(FitWork& work, int x) {
    AddProducts();
    AddRidge();
    Solve();
    Fitted(work, x);
  }

 private:
  using Row = std::array<float, lanes>;
  static constexpr std::size_t guide_count = FitTile::guide_count, unknowns = 3 + guide_count;

  void AddNeighbor(int dx, int dy, Floats weight) {
    const Lanes d;
    const std::size_t n = count_++;
    along_x_[n] = static_cast<float>(dx) / FitTile::window;
    along_y_[n] = static_cast<float>(dy) / FitTile::window;
    offsets_[n] = std::ptrdiff_t{dy} * FitTile::pitch + dx;
    hn::Store(weight, d, weights_[n].data());
    for (std::size_t k = 0; k < guide_count; ++k)
      hn::Store(
          hn::Sub(hn::LoadU(d, tile_.guides[k].data() + at_ + offsets_[n]), hn::LoadU(d, tile_.best[k].data() + at_)),
          d, guides_[n][k].data());
  }

  static constexpr std::size_t RowOf(std::size_t i) { return i * (i + 1) / 2; }

  void AddProducts() {
    AddProductsOfPlaces();
    AddProductsOfGuides(std::make_index_sequence<guide_count>());
  }

  void AddProductsOfPlaces() {
    const Lanes d;
    Floats sums[6];
    for (Floats& sum : sums) sum = hn::Zero(d);
    for (std::size_t n = 0; n < count_; ++n) {
      const Floats w = hn::Load(d, weights_[n].data()), x = hn::Set(d, along_x_[n]), y = hn::Set(d, along_y_[n]);
      const Floats wx = hn::Mul(w, x), wy = hn::Mul(w, y);
      sums[0] = hn::Add(sums[0], w);
      sums[1] = hn::Add(sums[1], wx);
      sums[2] = MultiplyAndAdd(wx, x, sums[2]);
      sums[3] = hn::Add(sums[3], wy);
      sums[4] = MultiplyAndAdd(wy, x, sums[4]);
      sums[5] = MultiplyAndAdd(wy, y, sums[5]);
    }
    for (std::size_t i = 0; i < 6; ++i) hn::Store(sums[i], d, products_[i].data());
  }

  template <std::size_t... i>
  void AddProductsOfGuides(std::index_sequence<i...>) {
    (AddRow(std::make_index_sequence<i + 1>()), ...);
  }

  /// Adds the products of a guide with those up to it, which stay in registers over all neighbors.
  template <std::size_t... j>
  HWY_NOINLINE void AddRow(std::index_sequence<j...>) {
    const Lanes d;
    constexpr std::size_t i = sizeof...(j) - 1;
    Floats one = hn::Zero(d), x = hn::Zero(d), y = hn::Zero(d), products[] = {(static_cast<void>(j), hn::Zero(d))...};
    for (std::size_t n = 0; n < count_; ++n) {
      const Floats weighted = hn::Mul(hn::Load(d, weights_[n].data()), hn::Load(d, guides_[n][i].data()));
      one = hn::Add(one, weighted);
      x = MultiplyAndAdd(weighted, hn::Set(d, along_x_[n]), x);
      y = MultiplyAndAdd(weighted, hn::Set(d, along_y_[n]), y);
      ((products[j] = MultiplyAndAdd(weighted, hn::Load(d, guides_[n][j].data()), products[j])), ...);
    }
    Row* row = &products_[RowOf(3 + i)];
    hn::Store(one, d, row[0].data());
    hn::Store(x, d, row[1].data());
    hn::Store(y, d, row[2].data());
    (hn::Store(products[j], d, row[3 + j].data()), ...);
  }

  void AddRidge() {
    const Lanes d;
    const Floats total = hn::Load(d, products_[0].data());
    for (std::size_t i = 1; i < unknowns; ++i) {
      Row& diagonal = products_[RowOf(i) + i];
      const Floats ridge = hn::Mul(hn::Set(d, i < 3 ? ridge_of_places : ridge_of_guides), total);
      const Floats square = hn::Load(d, diagonal.data());
      hn::Store(hn::Add(square, MultiplyAndAdd(square, hn::Set(d, ridge_of_rounding), ridge)), d, diagonal.data());
    }
  }

  /// Solves for the weights of the regressors in the fitted value where all regressors except the first are 0: the
  /// first column of the inverse.
  ///   source   symmetric Gaussian elimination from the last upwards; ridge regression by Hoerl and Kennard (1970)
  void Solve() {
    const Lanes d;
    const Floats least = hn::Mul(hn::Load(d, products_[0].data()), hn::Set(d, least_remainder));
    for (std::size_t pivot = unknowns - 1; pivot > 0; --pivot) {
      Row* row = &products_[RowOf(pivot)];
      const Floats inverse = hn::Div(hn::Set(d, 1), hn::Load(d, row[pivot].data()));
      for (std::size_t i = 0; i < pivot; ++i) {
        const Floats share = hn::Mul(hn::Load(d, row[i].data()), inverse);
        Row* target = &products_[RowOf(i)];
        for (std::size_t j = 0; j <= i; ++j)
          hn::Store(hn::Sub(hn::Load(d, target[j].data()), hn::Mul(share, hn::Load(d, row[j].data()))), d,
                    target[j].data());
      }
      for (std::size_t i = 0; i < pivot; ++i) hn::Store(hn::Mul(hn::Load(d, row[i].data()), inverse), d, row[i].data());
    }
    solution_[0] = hn::Div(hn::Set(d, 1), hn::Max(hn::Load(d, products_[0].data()), least));
    for (std::size_t i = 1; i < unknowns; ++i) {
      Floats sum = hn::Zero(d);
      for (std::size_t j = 0; j < i; ++j)
        sum = MultiplyAndAdd(hn::Load(d, products_[RowOf(i) + j].data()), solution_[j], sum);
      solution_[i] = hn::Neg(sum);
    }
  }

  /// Returns the neighbor's weight in the fitted color.
  Floats Share(std::size_t n) const {
    const Lanes d;
    Floats share = MultiplyAndAdd(solution_[1], hn::Set(d, along_x_[n]), solution_[0]);
    share = MultiplyAndAdd(solution_[2], hn::Set(d, along_y_[n]), share);
    for (std::size_t k = 0; k < guide_count; ++k)
      share = MultiplyAndAdd(solution_[3 + k], hn::Load(d, guides_[n][k].data()), share);
    return hn::Mul(share, hn::Load(d, weights_[n].data()));
  }

  void Fitted(FitWork& work, int x) const {
    const Lanes d;
    Floats sums[3], low[3], high[3];
    for (std::size_t k = 0; k < 3; ++k) {
      sums[k] = hn::Zero(d);
      low[k] = high[k] = hn::LoadU(d, tile_.colors[k].data() + at_);
    }
    for (std::size_t n = 0; n < count_; ++n) {
      const Floats share = Share(n);
      const auto counts = hn::Gt(hn::Load(d, weights_[n].data()), hn::Zero(d));
      for (std::size_t k = 0; k < 3; ++k) {
        const Floats color = hn::LoadU(d, tile_.colors[k].data() + at_ + offsets_[n]);
        sums[k] = MultiplyAndAdd(share, color, sums[k]);
        low[k] = hn::IfThenElse(counts, hn::Min(low[k], color), low[k]);
        high[k] = hn::IfThenElse(counts, hn::Max(high[k], color), high[k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      // Sums of colors near the largest float may be NaN.
      const Floats sum = hn::IfThenElse(hn::Eq(sums[k], sums[k]), sums[k], low[k]);
      hn::StoreU(hn::Max(low[k], hn::Min(high[k], sum)), d, work.fitted.At(x, static_cast<int>(k)));
    }
  }

  const FitTile& tile_;
  const std::ptrdiff_t at_;
  std::size_t count_ = 0;                                    // of neighbors that count in any lane
  std::array<float, Neighborhood::size> along_x_, along_y_;  // 1 at the rim of the window
  std::array<std::ptrdiff_t, Neighborhood::size> offsets_;
  alignas(64) std::array<Row, Neighborhood::size> weights_;
  alignas(64) std::array<std::array<Row, guide_count>, Neighborhood::size> guides_;
  alignas(64) std::array<Row, unknowns*(unknowns + 1) / 2> products_;  // lower triangle, in rows
  Floats solution_[unknowns];
};

void FitPixels(FitWork& work, int x0, int y0, Pixels<Rgb>& result) {
  for (int dy = -FitTile::window; dy <= FitTile::window; ++dy)
    for (int dx = -FitTile::window; dx <= FitTile::window; ++dx) MakeWeights(work, dx, dy);
  for (int y = 0; y < work.tile.Rows(); ++y) {
    for (int x = 0; x < work.tile.Columns(); x += lanes) Fit(work, x, y).WriteTo(work, x);
    for (int x = 0; x < work.tile.Columns(); ++x)
      for (std::size_t k = 0; k < 3; ++k) result.At(x0 + x, y0 + y)[k] = *work.fitted.At(x, static_cast<int>(k));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray {
namespace {

HWY_EXPORT(FitPixels);

constexpr int TilesAcross(int pixels, int side) { return (pixels + side - 1) / side; }

}  // namespace

std::int64_t LocalFitTiles(int width, int height) {
  return std::int64_t{TilesAcross(width, FitTile::columns)} * TilesAcross(height, FitTile::rows);
}

Pixels<Rgb> LocalFit(const LocalFitInput& input, WorkMeter& meter) {
  Pixels<Rgb> result(input.colors.Width(), input.colors.Height());
  const int across = TilesAcross(result.Width(), FitTile::columns);
  const int tiles = across * TilesAcross(result.Height(), FitTile::rows);
  tbb::enumerable_thread_specific<FitWork> works;
  tbb::parallel_for(0, tiles, [&](int i) {
    if (meter.IsStopped()) return;
    FitWork& work = works.local();
    const int x0 = i % across * FitTile::columns, y0 = i / across * FitTile::rows;
    work.tile.Load(input, x0, y0);
    HWY_DYNAMIC_DISPATCH(FitPixels)(work, x0, y0, result);
    meter.PartIsDone();
  });
  return result;
}

}  // namespace ray
#endif

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "R2/Point.h"
#include "source/sample/Random.h"
#include "source/sample/Sobol.h"

namespace ray {

/// The sample sequence of a pixel. sobol: Owen-scrambled, evenly distributed in all dimensions that belong together.
/// random: independent. stratified: jittered in pairs of dimensions, for a number of samples known beforehand. grid:
/// camera rays through the middles of n x n equal parts of the pixel, everything else as by sobol. rotated_grid: those
/// n x n places turned about the pixel's middle by atan(1 / n), so that no two are in one row or column. poisson:
/// camera rays through places of the pixel that keep a distance from each other, everything else as by sobol.
enum class SamplerKind { sobol, random, stratified, grid, rotated_grid, poisson };
inline constexpr std::array sampler_names{"sobol", "random", "stratified", "grid", "rotated_grid", "poisson"};
constexpr const auto& NamesOf(SamplerKind) { return sampler_names; }
/// Whether places in a pixel are laid out for a square number of them.
constexpr bool IsGrid(SamplerKind kind) { return kind == SamplerKind::grid || kind == SamplerKind::rotated_grid; }
/// Whether all random choices but places in a pixel are Sobol's.
constexpr bool UsesSobol(SamplerKind kind) { return kind != SamplerKind::random && kind != SamplerKind::stratified; }

/// The points of the unit square, or hypercube, that one kind of random choice at one vertex of the tree of rays uses
/// in the samples of one pixel. Point `index` is a function of (kind, key, index), and of `count` for stratified
/// points.
class Points {
 public:
  /// `count`: how many there will be; beyond it, and beyond 2^32 - 1, stratified points begin anew with other strata.
  Points(SamplerKind kind, const RandomKey& key, std::uint64_t count) : Points(kind, key, count, key, 0) {}
  /// More coordinates of the points that `first` has the first ones of, even together with them: from number
  /// `dimension` on, so that with `size` at most Sobol::dimensions. Only Sobol's points have anything in common.
  Points(SamplerKind kind, const RandomKey& key, std::uint64_t count, const RandomKey& first, int dimension)
      : kind_(kind), key_(key), count_(CountOfStrata(count)), order_(High(first)), dimension_(dimension) {}

  /// Returns `size` coordinates, at most Sobol::dimensions, each in [0, 1).
  template <std::size_t size>
  std::array<double, size> Get(std::uint64_t index) const {
    if (UsesSobol(kind_)) {
      const auto in_sequence = static_cast<std::uint32_t>(index);  // which repeats after 2^32 points
      return dimension_ == 0 ? SobolPoint<size>(in_sequence, std::integral_constant<int, 0>())
                             : SobolPoint<size>(in_sequence, dimension_);
    }
    std::array<double, size> coordinates;
    Fill(index, coordinates.data(), size);
    return coordinates;
  }

  /// The first two coordinates, in [0, 1)^2.
  R2::Point Get2D(std::uint64_t index) const {
    const auto [x, y] = Get<2>(index);
    return {x, y};
  }

  /// Writes the coordinates of `count` points from number `first` on.
  void GetEach2D(std::uint64_t first, std::uint32_t count, double* x, double* y) const;

 private:
  static std::uint32_t CountOfStrata(std::uint64_t count) {
    return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(count, 1, ~0u));
  }
  static std::uint32_t High(const RandomKey& key) { return static_cast<std::uint32_t>(key.Bits() >> 32); }
  static std::uint32_t Low(const RandomKey& key) { return static_cast<std::uint32_t>(key.Bits()); }
  /// `first`: the dimension of the first coordinate, as a type where it is always the same.
  template <std::size_t size, typename Dimension>
  std::array<double, size> SobolPoint(std::uint32_t index, Dimension first) const {
    std::array<double, size> coordinates;
    const Sobol point(index, order_);
#pragma GCC unroll 8  // so that hashing i / 2 costs nothing
    for (std::size_t i = 0; i < size; ++i) {
      const RandomKey seeds = key_.Child(i / 2);
      coordinates[i] = point.Coordinate(first + static_cast<int>(i), i % 2 == 0 ? High(seeds) : Low(seeds));
    }
    return coordinates;
  }
  /// Fills in the coordinates of samplers other than Sobol's.
  void Fill(std::uint64_t index, double* coordinates, std::size_t size) const;
  Stratified PairOf(std::uint64_t index, std::uint64_t pair) const;

  SamplerKind kind_;
  RandomKey key_;
  std::uint32_t count_, order_;
  int dimension_;
};

/// The child of a key that a camera ray's own choices come from; no surface has as many lights.
inline constexpr std::uint64_t camera_key = ~std::uint64_t{0};

/// Which sample of which pixel something belongs to, and where in that sample's tree of rays: what all its random
/// numbers are a function of.
struct SampleIndex {
  RandomKey key{0};           // of the pixel and the vertex of the tree, the same for all samples of the pixel
  std::uint32_t sample = 0;   // its number in the pixel
  int camera_dimensions = 0;  // at the first surface, that light's choices should be even together with; 0 for none

  /// The index for the vertex numbered `which` below this one.
  SampleIndex Child(std::uint64_t which) const { return {key.Child(which), sample}; }
  /// The points for choices numbered `which` here; `each` of them a sample, of which this has the numbers FirstOf(each)
  /// and on.
  Points PointsFor(std::uint64_t which, SamplerKind kind, std::uint32_t samples, std::uint32_t each = 1) const {
    if (camera_dimensions == 0 || each > 1) return Points(kind, key.Child(which), std::uint64_t{samples} * each);
    return Points(kind, key.Child(which), samples, key.Child(camera_key), camera_dimensions);
  }
  /// In 64 bits, which samples times shadow rays may need.
  std::uint64_t FirstOf(std::uint32_t each) const { return std::uint64_t{sample} * each; }
};

}  // namespace ray

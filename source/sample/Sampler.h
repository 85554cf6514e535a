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
/// random: independent. stratified: jittered in pairs of dimensions, for a number of samples known in advance. grid:
/// camera rays through the centers of n x n equal parts of the pixel, everything else as for sobol. rotated_grid: the
/// same n x n points rotated about the pixel's center by atan(1 / n), so that no two are in one row or column. poisson:
/// camera rays through points of the pixel that keep a distance from each other, everything else as for sobol.
enum class SamplerKind { sobol, random, stratified, grid, rotated_grid, poisson };
inline constexpr std::array sampler_names{"sobol", "random", "stratified", "grid", "rotated_grid", "poisson"};
constexpr const auto& NamesOf(SamplerKind) { return sampler_names; }
/// Returns true if the points in a pixel are laid out for a square number of samples.
constexpr bool IsGrid(SamplerKind kind) { return kind == SamplerKind::grid || kind == SamplerKind::rotated_grid; }
/// Returns true if all random choices except points in a pixel use Sobol's sequence.
constexpr bool UsesSobol(SamplerKind kind) { return kind != SamplerKind::random && kind != SamplerKind::stratified; }

/// The points of the unit square, or hypercube, that one kind of random choice at one vertex of the tree of rays uses
/// in the samples of one pixel. Point `index` is a function of (kind, key, index), and for stratified points also of
/// `count`.
class Points {
 public:
  /// Makes `count` points; beyond that number, and beyond 2^32 - 1, stratified points start again with other strata.
  Points(SamplerKind kind, const RandomKey& key, std::uint64_t count) : Points(kind, key, count, key, 0) {}
  /// Makes further coordinates, from number `dimension` on, of the points whose first coordinates belong to `first`,
  /// stratified together with them; with `size` at most Sobol::dimensions. Only Sobol's points are stratified together.
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

  /// Returns the first two coordinates, in [0, 1)^2.
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
  /// Computes coordinates; `first` is the dimension of the first one, passed as a type if it is constant.
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
  /// Computes the coordinates for samplers other than Sobol's.
  void Fill(std::uint64_t index, double* coordinates, std::size_t size) const;
  Stratified PairOf(std::uint64_t index, std::uint64_t pair) const;

  SamplerKind kind_;
  RandomKey key_;
  std::uint32_t count_, order_;
  int dimension_;
};

/// The child key of a camera ray's own choices; no surface has as many lights.
inline constexpr std::uint64_t camera_key = ~std::uint64_t{0};

/// The sample of a pixel, and the vertex in that sample's tree of rays, of which all its random numbers are a function.
struct SampleIndex {
  RandomKey key{0};           // of the pixel and the vertex of the tree, the same for all samples of the pixel
  std::uint32_t sample = 0;   // its number in the pixel
  int camera_dimensions = 0;  // camera dimensions to stratify light choices at the first surface with; 0: none

  /// Returns the index of the vertex numbered `which` below this one.
  SampleIndex Child(std::uint64_t which) const { return {key.Child(which), sample}; }
  /// Returns the points for choices numbered `which` here, with `each` points per sample; this sample uses the numbers
  /// from FirstOf(each) on.
  Points PointsFor(std::uint64_t which, SamplerKind kind, std::uint32_t samples, std::uint32_t each = 1) const {
    if (camera_dimensions == 0 || each > 1) return Points(kind, key.Child(which), std::uint64_t{samples} * each);
    return Points(kind, key.Child(which), samples, key.Child(camera_key), camera_dimensions);
  }
  /// Returns the number of the first point, in 64 bits, which samples times shadow rays may need.
  std::uint64_t FirstOf(std::uint32_t each) const { return std::uint64_t{sample} * each; }
};

}  // namespace ray

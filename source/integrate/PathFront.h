#pragma once

#include <array>
#include <span>
#include <vector>

#include "R1/Columns.h"
#include "source/integrate/shading/PhongColumns.h"
#include "source/sample/PointBatch.h"

namespace ray {

/// The surfaces that paths have reached, all after the same number of bounces. Data for loops over all of them is
/// stored in columns, one array per number, so that the loops become vector instructions.
struct PathFront {
  using Each = LightSamples::Each;

  template <typename Thing>
  using PerPoint = std::array<Thing, LightSamples::most>;

  std::vector<ShadingPoint> points;
  // For each point: the numbers of its camera sample, of the point before it on the path and of the ray between them.
  PerPoint<std::uint32_t> paths, from, rays;
  // Set by MakeColumns.
  PerPoint<SampleIndex> indices;
  R1::Columns<R3::Vector> normals;
  R1::Columns<R2::Color> kd, throughputs;
  alignas(64) Each clearances;        // of the points' departures
  alignas(64) Each diffuse_flags;     // 1 for a diffuse lobe alone, otherwise 0
  std::vector<std::uint32_t> others;  // points with other lobes
  std::vector<Bsdf> bsdfs;            // of others
  // Set by MakeColumnsOfHighlights.
  bool has_highlights;
  R1::Columns<R3::Vector> wo;
  R1::Columns<R2::Color> ks;
  PerPoint<std::uint64_t> exponents;           // 0 if not whole numbers
  std::uint64_t exponent_bits;                 // all exponents combined by or
  std::vector<std::uint32_t> others_by_phong;  // points with a coat, a map, or an exponent that is not whole

  /// Adds a point whose path and hit are known.
  ShadingPoint& Add(const R3::Ray& ray, const PathState& path, const WorldHit& hit, std::uint32_t sample,
                    std::uint32_t from_point, std::uint32_t ray_number) {
    const std::size_t i = points.size();
    paths[i] = sample, from[i] = from_point, rays[i] = ray_number;
    return points.emplace_back(ray, path, hit);
  }
  void Clear() { points.clear(), others.clear(), bsdfs.clear(); }
  template <typename Thing>
  std::span<const Thing> Of(const PerPoint<Thing>& all) const {
    return std::span(all).first(points.size());
  }
  /// Makes the columns when all points are complete. Those that only lights of the scene language need are made on
  /// demand.
  void MakeColumns(const MaterialTraitsOf& traits, const TraceSettings& settings);
  void MakeColumnsOfHighlights(const MaterialTraitsOf& traits);

  /// Converts light samples with pdfs, one for each point, to the light that purely diffuse surfaces reflect.
  ///   most_weight   of BSDF sampling; 0 without it
  void ReflectDiffusely(double most_weight, const Each& pdfs, LightSamples& samples) const;
  /// Applies PhongReflection to samples of one of the scene language's lights, one for each point; the result is wrong
  /// for others_by_phong.
  void ReflectByPhong(LightSamples& samples) const {
    ray::ReflectByPhong({normals, wo, kd, ks, exponents.data(), exponent_bits, has_highlights}, samples);
  }

  /// The continuations of paths from the points, in at most one direction each.
  struct Scattered {
    R1::Columns<R3::Vector> directions;  // unit; diffuse ones unless another was chosen
    R1::Columns<R2::Color> throughputs;  // after Russian roulette; 0 if the path ends
    alignas(64) Each pdfs;               // of the directions, as in BsdfSample
    PerPoint<Lobe> lobe;
    /// The numbers of the points that scatter by each lobe. Rays of one lobe are traced together: they are of one kind,
    /// and those from mirrors and glass are nearly parallel.
    std::array<std::vector<std::uint32_t>, lobes> by_lobe;

    void Add(std::uint32_t point, Lobe chosen) {
      lobe[point] = chosen;
      by_lobe[static_cast<std::size_t>(chosen)].push_back(point);
    }
  };
  /// Scatters at purely diffuse surfaces. Paths survive Russian roulette with a probability of at least
  /// `least_survival`.
  ///   random   two choices for a direction, and the last one for Russian roulette
  Scattered ScatterDiffusely(double least_survival, const PointBatch<4>& random) const;
};

}  // namespace ray

#pragma once

#include <array>
#include <span>
#include <vector>

#include "R1/Columns.h"
#include "source/integrate/shading/PhongColumns.h"
#include "source/sample/PointsOfEach.h"

namespace ray {

/// The surfaces that paths have reached, all after the same number of bounces. What is needed in loops over all of them
/// is kept in columns, one array per number, so that the loops become vector instructions.
struct PathFront {
  using Each = LightSamples::Each;

  template <typename Thing>
  using ArrayOfEach = std::array<Thing, LightSamples::most>;

  std::vector<ShadingPoint> points;
  // For each point: the numbers of its camera sample, of the point before it on the path and of the ray between them.
  ArrayOfEach<std::uint32_t> paths, from, rays;
  // Filled in by MakeColumns.
  ArrayOfEach<SampleIndex> indices;
  R1::Columns<R3::Vector> normals;
  R1::Columns<R2::Color> kd, throughputs;
  alignas(64) Each clearances;        // of their departures
  alignas(64) Each are_diffuse;       // 1 where the surface has a diffuse lobe alone, else 0
  std::vector<std::uint32_t> others;  // the points that have other lobes
  std::vector<Bsdf> bsdfs;            // of others
  // Filled in by MakeColumnsOfHighlights.
  bool has_highlights;
  R1::Columns<R3::Vector> wo;
  R1::Columns<R2::Color> ks;
  ArrayOfEach<std::uint64_t> exponents;        // 0 where they are not whole
  std::uint64_t exponent_bits;                 // all exponents or-ed
  std::vector<std::uint32_t> others_by_phong;  // with a coat, a map, or no whole exponent

  /// Adds a point of which path and hit are known.
  ShadingPoint& Add(const R3::Ray& ray, const PathState& path, const WorldHit& hit, std::uint32_t sample,
                    std::uint32_t from_point, std::uint32_t ray_number) {
    const std::size_t i = points.size();
    paths[i] = sample, from[i] = from_point, rays[i] = ray_number;
    return points.emplace_back(ray, path, hit);
  }
  void Clear() { points.clear(), others.clear(), bsdfs.clear(); }
  template <typename Thing>
  std::span<const Thing> Of(const ArrayOfEach<Thing>& all) const {
    return std::span(all).first(points.size());
  }
  /// Makes the columns, when all points are complete. What only lights of the scene language need is made on demand.
  void MakeColumns(const MaterialTraitsOf& traits, const TraceSettings& settings);
  void MakeColumnsOfHighlights(const MaterialTraitsOf& traits);

  /// Turns light samples with pdfs, one for each point, into the light that surfaces with a diffuse lobe alone reflect.
  ///   most_weight   of BSDF sampling: 0 where there is none
  void ReflectDiffusely(double most_weight, const Each& pdfs, LightSamples& samples) const;
  /// Applies PhongReflection to samples of one of the scene language's lights, one for each point; that of
  /// others_by_phong comes out wrong.
  void ReflectByPhong(LightSamples& samples) const {
    ray::ReflectByPhong({normals, wo, kd, ks, exponents.data(), exponent_bits, has_highlights}, samples);
  }

  /// How paths continue from the points: in at most one direction each.
  struct Scattered {
    R1::Columns<R3::Vector> directions;  // unit; diffuse ones where nothing else was chosen
    R1::Columns<R2::Color> throughputs;  // after Russian roulette; 0 where the path ends
    alignas(64) Each pdfs;               // of the directions, as of a BsdfSample
    ArrayOfEach<Lobe> lobe;
    /// The numbers of the points that scatter by each lobe. Rays of one lobe are traced together: they are of one kind,
    /// and those that mirrors and glass send on go nearly the same way.
    std::array<std::vector<std::uint32_t>, lobes> by_lobe;

    void Add(std::uint32_t point, Lobe chosen) {
      lobe[point] = chosen;
      by_lobe[static_cast<std::size_t>(chosen)].push_back(point);
    }
  };
  /// Scatters at surfaces with a diffuse lobe alone. Paths survive Russian roulette with a probability of at least
  /// `least_survival`.
  ///   random   two choices for a direction, and the last one for Russian roulette
  Scattered ScatterDiffusely(double least_survival, const PointsOfEach<4>& random) const;
};

}  // namespace ray

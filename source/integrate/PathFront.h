#pragma once

#include <array>
#include <span>
#include <vector>

#include "R1/Columns.h"
#include "source/integrate/shading/PhongColumns.h"
#include "source/sample/PointsOfEach.h"

namespace ray {

/// The surfaces that paths have reached at one time, all after as many bounces. What loops over all of them need stands
/// in columns, a number an array over the paths, so that loops become vector instructions.
struct PathFront {
  using Each = LightSamples::Each;

  template <typename Thing>
  using ArrayOfEach = std::array<Thing, LightSamples::most>;

  std::vector<ShadingPoint> points;
  // For each point, the numbers of its camera sample, of the point that its path came from and of the ray that led
  // there.
  ArrayOfEach<std::uint32_t> paths, from, rays;
  // Made of all points, once they are known.
  ArrayOfEach<SampleIndex> indices;
  R1::Columns<R3::Vector> normals;
  R1::Columns<R2::Color> kd, throughputs;
  alignas(64) Each clearances;        // of their departures
  alignas(64) Each are_diffuse;       // 1 where the surface is diffuse alone, else 0
  std::vector<std::uint32_t> others;  // those that are not
  std::vector<Bsdf> bsdfs;            // of others
  // For lights of the scene language.
  bool has_highlights;
  R1::Columns<R3::Vector> wo;
  R1::Columns<R2::Color> ks;
  ArrayOfEach<std::uint64_t> exponents;        // 0 where they are not whole
  std::uint64_t exponent_bits;                 // those that any of them has
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
  /// Makes the columns, when all points are complete; those for lights of the scene language on demand.
  void MakeColumns(const MaterialTraitsOf& traits, const TraceSettings& settings);
  void MakeColumnsOfHighlights(const MaterialTraitsOf& traits);

  /// Makes of light samples with pdfs what surfaces that are diffuse alone reflect of them, one sample a point.
  ///   most_weight   of BSDF sampling: 0 where there is none
  void ReflectDiffusely(double most_weight, const Each& pdfs, LightSamples& samples) const;
  /// Makes PhongReflection of samples of a light of the scene language, one a point; that of others_by_phong is wrong.
  void ReflectByPhong(LightSamples& samples) const {
    ray::ReflectByPhong({normals, wo, kd, ks, exponents.data(), exponent_bits, has_highlights}, samples);
  }

  /// How paths continue from the points: at most in one direction each.
  struct Scattered {
    R1::Columns<R3::Vector> directions;  // unit; diffuse ones where nothing else was chosen
    R1::Columns<R2::Color> throughputs;  // what survives Russian roulette, 0 where nothing does
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
  /// Scatters at surfaces that are diffuse alone. No path survives less likely than `least_survival`.
  ///   random   two choices for a direction, and the last one for Russian roulette
  Scattered ScatterDiffusely(double least_survival, const PointsOfEach<4>& random) const;
};

}  // namespace ray

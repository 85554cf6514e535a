#pragma once

#include <array>
#include <vector>

#include "source/integrate/shading/Bsdf.h"

namespace ray {

/// A vector of each of some paths.
struct VectorOfEach {
  alignas(64) LightSamples::Each x, y, z;

  R3::Vector operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void Set(std::size_t i, const R3::Vector& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

/// A color of each of some paths.
struct ColorOfEach {
  alignas(64) LightSamples::Each r, g, b;

  R2::Color operator[](std::size_t i) const { return {r[i], g[i], b[i]}; }
  void Set(std::size_t i, const R2::Color& c) { r[i] = c.r, g[i] = c.g, b[i] = c.b; }
};

/// The surfaces that paths have reached at one time, all after as many bounces. What loops over all of them need stands
/// in columns, a number an array over the paths, so that loops become vector instructions.
struct PathFront {
  using Each = LightSamples::Each;

  std::vector<ShadingPoint> points;
  std::vector<std::uint32_t> paths;  // of each point: the number of its camera sample
  // Made of all points, once they are known.
  std::vector<SampleIndex> indices;
  VectorOfEach normals;
  ColorOfEach kd, throughputs;
  alignas(64) Each are_diffuse;       // 1 where the surface is diffuse alone, else 0
  std::vector<std::uint32_t> others;  // those that are not
  std::vector<Bsdf> bsdfs;            // of others
  // For lights of the scene language.
  bool has_highlights;
  VectorOfEach wo;
  ColorOfEach ks;
  std::array<std::uint64_t, LightSamples::most> exponents;  // 0 where they are not whole
  std::uint64_t exponent_bits;                              // those that any of them has
  std::vector<std::uint32_t> others_by_phong;               // with a coat, a map, or no whole exponent

  /// Adds a point of which the path and the hit are known.
  void Add(const PathState& arriving, const WorldHit& hit, std::uint32_t path) {
    points.emplace_back(arriving, hit);
    paths.push_back(path);
  }
  void Clear() { points.clear(), paths.clear(), indices.clear(), others.clear(), bsdfs.clear(); }
  /// Makes the columns, when all points are complete; those for lights of the scene language on demand.
  void MakeColumns(const TraceSettings& settings);
  void MakeColumnsOfHighlights();

  /// Makes of light samples with pdfs what surfaces that are diffuse alone reflect of them, one sample a point.
  ///   most_weight   of BSDF sampling: 0 where there is none
  void ReflectDiffusely(double most_weight, const Each& pdfs, LightSamples& samples) const;
  /// Makes PhongReflection of samples of a light of the scene language, one a point, except of others_by_phong, which
  /// stay as they were.
  void ReflectByPhong(LightSamples& samples) const;

  /// Where diffuse surfaces send their paths.
  struct Scattered {
    ColorOfEach throughputs;  // what survives Russian roulette, 0 where nothing does
    alignas(64) Each pdfs;
  };
  /// Scatters at surfaces that are diffuse alone into each direction. No path survives less likely than
  /// `least_survival`.
  ///   choices   uniform in [0, 1), for Russian roulette
  Scattered ScatterDiffusely(double least_survival, const std::array<double, LightSamples::most>& choices,
                             const VectorOfEach& directions) const;
};

}  // namespace ray

#include "source/accelerate/wide/HullBlock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ray::wide {
namespace {

/// The map from the structure's coordinates to those of a hull.
struct HullMap {
  std::array<R3::Vector, 3> turn{};
  std::array<double, 3> shift{};
  double norm = 0;  // the largest row sum of magnitudes of both, including rounding in double precision
  bool is_as_high_as_the_box = true;
};

/// The minimum side of a hull in a structure's coordinates, which keeps numbers in the range of floats; flat hulls are
/// thickened to it.
constexpr double thinnest = 0x1p-20;

HullMap MapTo(const R3::Box& box, const R3::Matrix& local_from_world, const Coordinates& coordinates) {
  // A difference in double precision may be off by 2^-50 of the numbers that cancel. That is less than the rounding of
  // single precision, whose unit is 2^-24, for this share of them.
  constexpr double share_of_cancelling = 0x1p-26;
  HullMap map;
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    const auto& m = local_from_world.m[i];
    const R3::Vector row{m[0], m[1], m[2]}, center = FromOrigin(coordinates.center);
    const double middle = FromOrigin(box.Center())[axis], half = box.Size()[axis] / 2;
    const double per_unit = (std::abs(row.x) + std::abs(row.y) + std::abs(row.z)) / coordinates.scale;
    const double reach = std::max(half, thinnest * per_unit);
    if (axis == 1 && reach > half) map.is_as_high_as_the_box = false;
    map.turn[i] = row / coordinates.scale / reach;
    map.shift[i] = (Dot(row, center) + m[3] - middle) / reach;
    const double cancelling = Dot(Abs(row), Abs(center)) + std::abs(m[3]) + std::abs(middle);
    const double sum = per_unit / reach + std::abs(map.shift[i]) + share_of_cancelling * cancelling / reach;
    map.norm = !(sum <= map.norm) ? sum : map.norm;  // a NaN stays
  }
  return map;
}

/// Returns the volume, in the structure's coordinates, of the cube where all hull coordinates are in [-1, 1].
double VolumeOf(const HullMap& map) { return 8 / std::abs(Dot(map.turn[0], Cross(map.turn[1], map.turn[2]))); }

double VolumeOf(const R3::Box& box, const Coordinates& coordinates) {
  double volume = 1;
  for (int axis = 0; axis < 3; ++axis) volume *= std::max(box.Size()[axis] * coordinates.scale, 2 * thinnest);
  return volume;
}

void FillHull(HullBlock& block, int k, const Hull& hull, const Coordinates& coordinates) {
  const HullMap map = MapTo(hull.box, *hull.local_from_world, coordinates);
  const double margin = map.norm * hull.padding * coordinates.scale;
  constexpr double most_norm = 0x1p60, most_margin = 0x1p60;
  // Otherwise single precision does not resolve its position: an infinite margin accepts all rays.
  const bool is_known = map.norm <= most_norm && margin <= most_margin;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      block.turn[i][j][k] = is_known ? static_cast<float>(map.turn[i][static_cast<int>(j)]) : 0;
    block.shift[i][k] = is_known ? static_cast<float>(map.shift[i]) : 0;
  }
  // Beyond the ends of its box, a tapered profile no longer bounds the shape.
  const R3::Profile& profile = hull.profile;
  const bool is_tapered = map.is_as_high_as_the_box;
  block.radius[k] = static_cast<float>(is_tapered ? profile.radius : profile.radius + std::abs(profile.taper));
  block.taper[k] = static_cast<float>(is_tapered ? profile.taper : 0);
  block.bulge[k] = static_cast<float>(profile.bulge);
  constexpr double stretch_per_norm = 4;  // derived in Hulls-inl.h
  block.stretch[k] = is_known ? static_cast<float>(stretch_per_norm * map.norm) : 0;
  block.margin[k] = is_known ? static_cast<float>(margin) : std::numeric_limits<float>::infinity();
}

}  // namespace

bool IsHullTighter(const PrimitiveSet& primitives, const Coordinates& coordinates, std::uint32_t primitive) {
  // Hulls are slower for primitives that are not rotated, even for a cone, which fills a quarter of its box (1.1 to 1.4
  // times as slow among 40 or 400), and faster for randomly rotated ones (build/bench/solids). The threshold is in
  // between.
  constexpr double tight = 0.5;
  const Hull hull = primitives.HullOf(primitive);
  const double volume = VolumeOf(MapTo(hull.box, *hull.local_from_world, coordinates));
  return volume < tight * VolumeOf(primitives.Bounds(primitive), coordinates);
}

void FillHulls(HullBlock& block, const PrimitiveSet& primitives, const Coordinates& coordinates,
               const std::uint32_t* which, int count) {
  block = {};
  block.count = static_cast<std::uint32_t>(count);
  for (int k = 0; k < count; ++k) {
    FillHull(block, k, primitives.HullOf(which[k]), coordinates);
    block.primitive[k] = which[k];
  }
}

}  // namespace ray::wide

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "R2/Color.h"
#include "R2/Vector.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {

/// An image of a material, and its mapping to the surface.
struct MtlMap {
  std::string file;
  std::string place;                     // "car.mtl:7:8"
  R2::Vector scale{1, 1}, offset{0, 0};  // of texture coordinates: uv scale + offset
  bool is_clamped = false;               // shown once, not repeated
  double multiplier = 1;                 // of heights
};

/// A material as stated in a file; missing values are empty.
struct MtlMaterial {
  std::string name;
  std::string place;
  std::optional<R2::Color> Ka, Kd, Ks, Ke, Tf;
  std::optional<double> Ns, Ni, d, Tr;
  std::optional<int> illum;
  std::optional<MtlMap> map_Kd, bump, norm;
};

/// Reads a material library. Warns about statements without effect, once per kind, with the position of the first one.
/// Throws SceneError.
///   source   Wavefront, Advanced Visualizer manual, MTL material format (1995); Ke and norm as Blender writes them
std::vector<MtlMaterial> ReadMtl(const Text& file, Report& report);

}  // namespace ray

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "R2/Color.h"
#include "source/scene/Texture.h"

namespace ray {

struct SurfaceVertex {
  std::array<float, 3> at{};             // in a DrawingSpace
  std::array<std::int16_t, 4> normal{};  // unit, outward, in units of 1/32767; the last is for alignment
};

/// A material as the shader of the preview knows it.
struct SurfaceMaterial {
  R2::Color emission, ambient;  // the latter: ka times the scene's ambient light
  R2::Color kd, ks, kr, kt;
  double n = 1, ir = 1, coat = 0;
  double lobe = 0;  // angle, in radians, over which a glossy reflection is spread; 0: mirrored
  std::shared_ptr<const Texture> texture, specular_map, bump, normal_map;  // null for none
  R2::Vector texture_scale{1, 1};                                          // of all of these
  bool texture_multiplies_ambient = false;                                 // and vertex colors
  bool has_vertex_colors = false;
  bool one_sided = false;  // backs are not drawn
  double bump_height = 0;  // in the drawing space
  // Unlit, as mode flat shows it: the former times the texture, plus the latter.
  R2::Color flat_painted, flat_plain;
};

/// The triangles of one material, `count` indices from `first` on.
struct SurfaceBatch {
  SurfaceMaterial material;
  std::uint32_t first = 0, count = 0;
  bool is_clear = false;    // what is behind is seen through it
  int probe = -1;           // of Surfaces::probes, which its mirrors show; -1: none
  bool owns_probe = false;  // the probe is in the middle of it, and does not see it
};

/// Where the scene is looked at from, to all sides, so that mirrors and glass about that place can show it.
struct MirrorProbe {
  std::array<float, 3> at{};  // in a DrawingSpace
  double nearest = 2e-3;      // likewise: what is nearer is not seen
};
inline constexpr std::size_t most_mirror_probes = 16;

/// Triangles in batches, the opaque ones first. Fronts are outside.
struct Surfaces {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::array<float, 2>> uvs;     // one per vertex, or none where no material has a texture
  std::vector<std::array<float, 3>> colors;  // one per vertex, or none where no material has them
  std::vector<std::uint32_t> indices;        // three per triangle
  std::vector<SurfaceBatch> batches;
  std::vector<MirrorProbe> probes;  // at most most_mirror_probes
};

/// A normal as a vertex has it; `normal` is of length 1 at most.
inline std::array<std::int16_t, 4> Packed(double x, double y, double z) {
  const auto channel = [](double c) { return static_cast<std::int16_t>(c * 32767); };
  return {channel(x), channel(y), channel(z), 0};
}

}  // namespace ray

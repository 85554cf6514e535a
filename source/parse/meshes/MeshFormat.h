#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "R3/MeshData.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {

/// A name in a mesh file, such as that of a material.
struct MeshName {
  std::string name;
  std::string place;  // "car.obj:12:8"
};

/// The triangles of a mesh from one on, up to the next run, share something.
struct TriangleRun {
  std::size_t first_triangle;
  std::uint32_t value;
};

/// The value of each of so many triangles; `before` for those ahead of the first run.
std::vector<std::uint32_t> ValuesOfTriangles(std::span<const TriangleRun> runs, std::size_t triangles,
                                             std::uint32_t before);

/// What a mesh file holds: the mesh as a whole, and what tells its parts apart.
struct MeshFile {
  R3::MeshData data;
  std::vector<MeshName> material_files{};     // each the rest of a line, which may be several names
  std::vector<MeshName> materials{};          // as faces name them, each once
  std::vector<TriangleRun> material_runs{};   // indices into `materials`, or no_material as before the first
  std::vector<TriangleRun> smoothing_runs{};  // smoothing groups, or 0 for none as before the first
  std::vector<MeshName> textures{};           // image files that belong to no material
  bool has_8_bit_colors = false;              // colors of vertices were bytes, encoded as those of images are

  static constexpr std::uint32_t no_material = 0xFFFFFFFF;

  /// Whether it says how it looks.
  bool HasLook() const { return !material_runs.empty() || !textures.empty() || !data.colors.empty(); }
};

/// One line of mesh_formats.def.
struct MeshFormat {
  const char* extension;  // lower case, with the dot
  /// Reads a mesh in time and memory linear in the file's length. Throws SceneError pointing into the file.
  MeshFile (*read)(const Text& file, Report& report);
};

/// All formats, in the order of mesh_formats.def.
std::span<const MeshFormat* const> MeshFormats();
/// The format of an extension, in any letter case; null if there is none.
const MeshFormat* MeshFormatForName(const std::string& name);
/// ".off, .ray, ..."
std::string MeshExtensions();

}  // namespace ray

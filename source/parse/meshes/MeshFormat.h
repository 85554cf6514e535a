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

/// Consecutive triangles with a common property, up to the next run.
struct TriangleRun {
  std::size_t first_triangle;
  std::uint32_t value;
};

/// Returns the value of each of the triangles; `before` applies before the first run.
std::vector<std::uint32_t> ValuesOfTriangles(std::span<const TriangleRun> runs, std::size_t triangles,
                                             std::uint32_t before);

/// The contents of a mesh file: the whole mesh, and the properties of its parts.
struct MeshFile {
  R3::MeshData data;
  std::vector<MeshName> material_files{};     // each the rest of a line, which may contain several names
  std::vector<MeshName> materials{};          // as named by faces, each once
  std::vector<TriangleRun> material_runs{};   // indices into `materials`; no_material applies before the first
  std::vector<TriangleRun> smoothing_runs{};  // smoothing groups, or 0 for none, which applies before the first
  std::vector<MeshName> textures{};           // image files without a material
  bool has_8_bit_colors = false;              // vertex colors were bytes, encoded like those of images

  static constexpr std::uint32_t no_material = 0xFFFFFFFF;

  /// Returns true if the file states the appearance.
  bool HasLook() const { return !material_runs.empty() || !textures.empty() || !data.colors.empty(); }
};

/// One line of mesh_formats.def.
struct MeshFormat {
  const char* extension;  // lower case, with the dot
  /// Reads a mesh in time and memory linear in the file's length. Throws SceneError with a position in the file.
  MeshFile (*read)(const Text& file, Report& report);
};

/// Returns all formats, in the order of mesh_formats.def.
std::span<const MeshFormat* const> MeshFormats();
/// Returns the format for an extension, in any letter case, or null.
const MeshFormat* MeshFormatForName(const std::string& name);
/// Returns ".off, .ray, ...".
std::string MeshExtensions();

}  // namespace ray

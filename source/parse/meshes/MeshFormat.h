#pragma once

#include <span>
#include <string>

#include "source/parse/Report.h"
#include "source/parse/Text.h"
#include "source/parse/meshes/MeshFile.h"

namespace ray {

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

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "source/parse/meshes/MeshFormat.h"

namespace ray {

/// The contents of a mesh file, and the warnings of reading it.
struct ReadMesh {
  R3::MeshData data;
  std::vector<std::string> warnings;
};

inline ReadMesh MeshOfBytes(const std::string& name, std::string bytes) {
  Report report;
  const Text text{name, std::move(bytes)};
  ReadMesh read{MeshFormatForName(name)->read(text, report).data, {}};
  read.warnings = report.Warnings();
  return read;
}

/// Returns position, reason and hint of the error of reading it; "(none)" if there is none.
inline std::string MeshErrorOf(const std::string& name, std::string bytes) {
  try {
    MeshOfBytes(name, std::move(bytes));
    return "(none)";
  } catch (const SceneError& error) {
    return Place(error.file, error.line, error.column) + ": " + error.message +
           (error.hint.empty() ? "" : "; " + error.hint);
  }
}

}  // namespace ray

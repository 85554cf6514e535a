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

}  // namespace ray

#include "source/parse/meshes/MeshFormat.h"

#include <array>
#include <filesystem>

#include "R1/Kinds.h"
#include "source/text/LowerCase.h"

namespace ray {

std::span<const MeshFormat* const> MeshFormats() {
#define MESH_FORMAT(name) KIND(MeshFormat, name##_mesh_format),
  static const std::array formats{
#include "source/parse/meshes/mesh_formats.def"
  };
  return formats;
}

const MeshFormat* MeshFormatForName(const std::string& name) {
  const std::string extension = LowerCase(std::filesystem::path(name).extension().string());
  for (const MeshFormat* format : MeshFormats())
    if (extension == format->extension) return format;
  return nullptr;
}

std::string MeshExtensions() {
  std::string all;
  for (const MeshFormat* format : MeshFormats()) all += (all.empty() ? "" : ", ") + std::string(format->extension);
  return all;
}

}  // namespace ray

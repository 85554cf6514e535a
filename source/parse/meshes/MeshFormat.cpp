#include "source/parse/meshes/MeshFormat.h"

#include <array>
#include <filesystem>

#include "source/text/LowerCase.h"

namespace ray {

#define MESH_FORMAT(name) extern const MeshFormat name##_mesh_format;
#include "source/parse/meshes/mesh_formats.def"
#undef MESH_FORMAT

namespace {

const std::array formats{
#define MESH_FORMAT(name) &name##_mesh_format,
#include "source/parse/meshes/mesh_formats.def"
#undef MESH_FORMAT
};

}  // namespace

std::span<const MeshFormat* const> MeshFormats() { return formats; }

const MeshFormat* MeshFormatForName(const std::string& name) {
  const std::string extension = LowerCase(std::filesystem::path(name).extension().string());
  for (const MeshFormat* format : formats)
    if (extension == format->extension) return format;
  return nullptr;
}

std::string MeshExtensions() {
  std::string all;
  for (const MeshFormat* format : formats) all += (all.empty() ? "" : ", ") + std::string(format->extension);
  return all;
}

}  // namespace ray

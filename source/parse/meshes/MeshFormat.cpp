#include "source/parse/meshes/MeshFormat.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "R1/Kinds.h"
#include "source/text/LowerCase.h"

namespace ray {

std::vector<std::uint32_t> ValuesOfTriangles(std::span<const TriangleRun> runs, std::size_t triangles,
                                             std::uint32_t before) {
  std::vector<std::uint32_t> values(triangles, before);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t first = runs[i].first_triangle,
                      end = i + 1 < runs.size() ? runs[i + 1].first_triangle : triangles;
    std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), end - first, runs[i].value);
  }
  return values;
}

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

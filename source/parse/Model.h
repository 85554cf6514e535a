#pragma once

#include <optional>
#include <vector>

#include "source/parse/Assets.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/scene/Material.h"

namespace ray {

/// The color of materials that state none.
inline constexpr R2::Color default_gray{0.6, 0.6, 0.6};

/// Returns a diffuse material, which reflects ambient light as much as any other.
Material DiffuseMaterial(const R2::Color& kd);

/// A mesh split into parts with one material each.
struct ModelData {
  struct Part {
    R3::MeshData data;
    std::optional<std::size_t> material{};  // index into `materials`; std::nullopt if the file states none
    bool is_whole = false;                  // the unchanged mesh of the file
  };
  std::vector<Material> materials;
  std::vector<Part> parts;
};

/// Splits a mesh by the materials that its file names in libraries, or by its vertex colors and textures. Warns about
/// files and features that are missing or not supported.
///   file   the mesh's own; others are searched next to it
ModelData CutByMaterial(MeshFile mesh, const FoundFile& file, Assets& assets, Report& report);

}  // namespace ray

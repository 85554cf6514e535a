#pragma once

#include <optional>
#include <vector>

#include "source/parse/Assets.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/scene/Material.h"

namespace ray {

/// The color of what says none.
inline constexpr R2::Color default_gray{0.6, 0.6, 0.6};

/// It reflects as much of ambient light as of any other.
Material DiffuseMaterial(const R2::Color& kd);

/// A mesh in parts of one material.
struct ModelData {
  struct Part {
    R3::MeshData data;
    std::optional<std::size_t> material{};  // index into `materials`; nothing where the file says none
    bool is_whole = false;                  // it is the mesh of the file as it stands
  };
  std::vector<Material> materials;
  std::vector<Part> parts;
};

/// Cuts a mesh by the materials that its file names in libraries, or that colors of its vertices and textures make.
/// What the file names and what is not there, or not supported, is told in warnings.
///   file   the mesh's, beside which others are looked for
ModelData CutByMaterial(MeshFile mesh, const FoundFile& file, Assets& assets, Report& report);

}  // namespace ray

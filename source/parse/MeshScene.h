#pragma once

#include "source/parse/Assets.h"
#include "source/parse/SceneError.h"

namespace ray {

/// A mesh at the top of `files` as a scene of its own: on a ground below a sky, lit by a sun and seen whole in
/// three-quarter view, with the materials, colors and smooth normals of its file, diffuse gray where that says none.
/// Mistakes go to the report.
Scene ReadMeshScene(const Files& files, const ParseOptions& options, Assets& assets, Report& report);

}  // namespace ray

#pragma once

#include "source/parse/Assets.h"
#include "source/parse/SceneError.h"

namespace ray {

/// Reads the mesh at the top of `files` as a scene: on a ground below a sky, lit by a sun and completely visible in
/// three-quarter view, with the materials, colors and smooth normals of its file, or diffuse gray if it has none.
/// Mistakes go to the report.
Scene ReadMeshScene(const Files& files, const ParseOptions& options, Assets& assets, Report& report);

}  // namespace ray

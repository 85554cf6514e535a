#pragma once

#include "source/parse/Assets.h"
#include "source/parse/Report.h"

namespace ray {

/// A mesh at the top of `files` as a scene of its own: default material, camera and lights, and the smooth normals that
/// the file brings, if any. Mistakes go to the report.
Scene ReadMeshScene(const Files& files, Assets& assets, Report& report);

}  // namespace ray

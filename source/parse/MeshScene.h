#pragma once

#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/Report.h"

namespace ray {

/// A mesh at the top of `files` as a scene of its own: default material, camera and lights, and the smooth normals that
/// the file brings, if any. Mistakes go to the report.
Scene ReadMeshScene(const Files& files, const ParseOptions& options, Report& report);

}  // namespace ray

#pragma once

#include <string>

#include "source/app/files/OutputFile.h"
#include "source/scene/Scene.h"

namespace ray {

/// Returns the file into which -convert writes the scene. Throws UsageError if its name does not end in .scn,
/// OutputError if it cannot be written or is the scene itself.
OutputFile CheckScnOutput(const std::string& name, const std::string& scene);

/// Writes the scene as .scn, and meshes without a file next to it; the scene last, so that its meshes exist when it
/// does. Warns on standard error about content that .scn cannot express and, unless quiet, about folders that its
/// reader must be allowed to use.
///   returns   which files were written, in lines; empty if quiet
/// Throws SceneErrors and OutputError.
std::string WriteSceneAsScn(const Scene& scene, const OutputFile& output, bool quiet);

}  // namespace ray

#pragma once

#include <string>

#include "source/app/files/OutputFile.h"
#include "source/scene/Scene.h"

namespace ray {

/// The file that -convert writes the scene into. Throws UsageError when its name is not one of .scn, OutputError when
/// it cannot be written or is the scene itself.
OutputFile CheckScnOutput(const std::string& name, const std::string& scene);

/// Writes the scene as .scn, and meshes that came from no file beside it; the scene last, so that when it is there,
/// what it names is too. Says on standard error what cannot be said in .scn, and, unless quiet, what its reader must be
/// allowed.
///   returns   which files were written, in lines; empty when quiet
/// Throws SceneErrors and OutputError.
std::string WriteSceneAsScn(const Scene& scene, const OutputFile& output, bool quiet);

}  // namespace ray

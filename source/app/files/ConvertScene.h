#pragma once

#include <string>

#include "source/app/options/Options.h"

namespace ray {

/// Writes the scene as .scn into the file that is the options' subject, and meshes that came from no file beside it;
/// the scene last, so that when it is there, what it names is too. Says on standard error what cannot be said in .scn,
/// and what its reader must be allowed.
///   returns   which files were written, in lines; empty when quiet
/// Throws UsageError, SceneErrors and OutputError.
std::string ConvertScene(const Options& options);

}  // namespace ray

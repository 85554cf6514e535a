#pragma once

#include <memory>

#include "source/app/options/Options.h"
#include "source/app/rayview/ViewOutputs.h"
#include "source/view/LoadedScene.h"

namespace ray {

/// Shows the scene until its user, or the script of events, has seen enough.
///   returns   an exit status
/// Throws ContextError when there is nothing to draw with.
int View(const Options& options, const ViewOutputs& outputs, std::shared_ptr<const LoadedScene> scene);

}  // namespace ray

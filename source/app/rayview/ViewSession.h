#pragma once

#include <memory>

#include "source/app/options/ViewerOptions.h"
#include "source/app/rayview/ViewOutputs.h"
#include "source/draw/contexts/Context.h"
#include "source/view/LoadedScene.h"

namespace ray {

/// Whether a user looks on. A script waits for ends, and is to draw the same again.
bool IsLookedAt(const ViewOptions& view);

/// Shows the scene until its user, or the script of events, has seen enough.
///   asked     what was typed; it is combined again with the settings of a scene that is read again
///   options   that, with the settings of this scene
///   mistakes  why the scene is not the file's, to be shown; null where it is
///   window    to be shown in; null to open one where there is to be any
///   returns   an exit status
/// Throws ContextError when there is nothing to draw with.
int View(const ViewerOptions& asked, const ViewerOptions& options, const ViewOutputs& outputs,
         std::shared_ptr<const LoadedScene> scene, const SceneErrors* mistakes = nullptr,
         std::unique_ptr<Window> window = nullptr);

}  // namespace ray

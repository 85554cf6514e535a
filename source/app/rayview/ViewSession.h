#pragma once

#include <memory>

#include "source/app/options/ViewerOptions.h"
#include "source/app/rayview/ViewOutputs.h"
#include "source/draw/contexts/Context.h"
#include "source/inspect/LoadedScene.h"

namespace ray {

/// Returns true if a user watches. A script waits for ends, and must draw the same every time.
bool IsLookedAt(const ViewOptions& view);

/// Shows the scene until its user, or the script of events, ends the session.
///   asked     as typed; combined again with the settings of a scene that is reloaded
///   options   those, with the settings of this scene
///   mistakes  why the scene is not the file's, to be shown; null if it is
///   window    to use; null to open one if necessary
///   returns   an exit status
/// Throws ContextError if there is nothing to draw with.
int View(const ViewerOptions& asked, const ViewerOptions& options, const ViewOutputs& outputs,
         std::shared_ptr<const LoadedScene> scene, const SceneErrors* mistakes = nullptr,
         std::unique_ptr<Window> window = nullptr);

}  // namespace ray

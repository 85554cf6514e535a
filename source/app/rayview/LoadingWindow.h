#pragma once

#include <future>
#include <memory>
#include <string>

#include "source/draw/contexts/Context.h"
#include "source/view/LoadedScene.h"

namespace ray {

/// Waits until the scene is there, in a window that says so where that takes longer than a moment.
///   returns   the window, for the scene to be shown in; null where it was there at once, or there are no windows
/// Ends the program where the user closes the window meanwhile.
std::unique_ptr<Window> WindowUntilLoaded(const std::future<std::shared_ptr<const LoadedScene>>& loading, int width,
                                          int height, const std::string& file);

}  // namespace ray

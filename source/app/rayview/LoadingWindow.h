#pragma once

#include <future>
#include <memory>
#include <string>

#include "source/draw/contexts/Context.h"
#include "source/inspect/LoadedScene.h"

namespace ray {

/// Waits until the scene is loaded, in a window with a message if that takes longer than a moment. Ends the program if
/// the user closes the window.
///   returns   the window, to be used for the scene; null if loading took no time, or there are no windows
std::unique_ptr<Window> WindowUntilLoaded(const std::future<std::shared_ptr<const LoadedScene>>& loading, int width,
                                          int height, const std::string& file);

}  // namespace ray

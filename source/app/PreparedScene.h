#pragma once

#include <memory>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/app/options/RenderOptions.h"

/// The one way of a scene from its file to the first ray.
namespace ray {

/// A scene as its file states it, and the options with its own settings among them.
struct ReadScene {
  /// Throws UsageError, for this machine too, and SceneErrors.
  explicit ReadScene(const RenderOptions& asked);

  ParsedScene parsed;
  RenderOptions options;
};

/// A scene that rays can be traced in, with the accelerator that the options ask for, built for about as many rays as
/// the render will trace.
struct PreparedScene {
  /// Throws UsageError where scene, structure and image would take more memory than they may.
  ///   read   is referred to, and lives longer
  explicit PreparedScene(const ReadScene& read);

  World world;
  std::unique_ptr<const Accelerator> accelerator;
};

}  // namespace ray

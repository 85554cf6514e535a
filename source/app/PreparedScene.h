#pragma once

#include <memory>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/app/options/RenderOptions.h"

/// The path of a scene from its file to the first ray, shared by all programs.
namespace ray {

/// A scene as stated in its file, and the options including its own settings.
struct ReadScene {
  /// Reads the scene. Throws UsageError, also for options that this machine does not support, and SceneErrors.
  explicit ReadScene(const RenderOptions& asked);

  ParsedScene parsed;
  RenderOptions options;
};

/// A scene ready for tracing, with the requested accelerator, built for about as many rays as the render will trace.
struct PreparedScene {
  /// Builds it, and decides for `read.options` whether paths share light. Throws UsageError if scene, structure and
  /// image would exceed the memory limit.
  ///   read   must outlive this
  explicit PreparedScene(ReadScene& read);

  World world;
  std::unique_ptr<const Accelerator> accelerator;
};

}  // namespace ray

#pragma once

#include <filesystem>
#include <memory>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/parse/Parse.h"

namespace ray {

/// A scene ready to be traced. Jobs share it, so that it lives until the last ray is back though the viewer has another
/// by then.
struct LoadedScene {
  LoadedScene(const std::filesystem::path& file, const ParseOptions& options, const AcceleratorSettings& how)
      : parsed(Parse(file, options)),
        world(parsed.scene),
        accelerator(FindAcceleratorKind(how.name)->Make(world, how)) {}

  ParsedScene parsed;
  World world;
  std::unique_ptr<const Accelerator> accelerator;
};

}  // namespace ray

#pragma once

#include <memory>
#include <string>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/parse/Parse.h"

namespace ray {

/// A scene ready to be rendered. Jobs share it, so that it lives until the last of them ends even if the viewer has
/// another by then.
struct LoadedScene {
  LoadedScene(const std::string& file, const ParseOptions& options, const AcceleratorSettings& how)
      : parsed(Parse(file, options)),
        world(parsed.scene),
        accelerator(FindAcceleratorKind(how.name)->Make(world, how)) {}

  ParsedScene parsed;
  World world;
  std::unique_ptr<const Accelerator> accelerator;
};

}  // namespace ray

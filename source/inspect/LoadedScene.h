#pragma once

#include <memory>
#include <string>
#include <utility>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/parse/Parse.h"
#include "source/parse/scn/ScnPlaces.h"

namespace ray {

/// A scene ready to be rendered. Jobs share it, so that it exists until the last of them ends, even after the viewer
/// has opened another.
struct LoadedScene {
  LoadedScene(const std::string& file, const ParseOptions& options, const AcceleratorSettings& how)
      : parsed(Parse(file, WithPlaces(options, places))),
        world(parsed.scene),
        accelerator(FindAcceleratorKind(how.name)->Make(world, how)) {}
  LoadedScene(ParsedScene scene, const AcceleratorSettings& how)
      : parsed(std::move(scene)), world(parsed.scene), accelerator(FindAcceleratorKind(how.name)->Make(world, how)) {}

  ScnPlaces places;  // empty if the scene is not a .scn file
  ParsedScene parsed;
  World world;
  std::unique_ptr<const Accelerator> accelerator;

 private:
  static ParseOptions WithPlaces(ParseOptions options, ScnPlaces& places) {
    options.places = &places;
    return options;
  }
};

}  // namespace ray

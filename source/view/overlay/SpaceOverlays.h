#pragma once

#include <string>

#include "source/accelerate/Accelerator.h"
#include "source/view/overlay/SceneLines.h"

namespace ray {

/// What is drawn in space of the scene, and beside it.
struct SpaceOverlays {
  enum class Boxes { none, nodes, accelerator };

  bool faces = true, edges = false, camera = false, lights = false;
  bool quad = true;     // the rendered image in space, where there is one
  bool shadows = true;  // of the preview, where the scene has any
  Boxes boxes = Boxes::none;
  int box_level = all_levels;
};

/// The boxes that are shown, as lines; none where none are.
BoxLines LinesOfBoxes(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                      const DrawingSpace& space);
std::string BoxesInWords(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                         const DrawingSpace& space);

}  // namespace ray

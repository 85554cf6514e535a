#include "source/view/overlay/SpaceOverlays.h"

namespace ray {

BoxLines LinesOfBoxes(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                      const DrawingSpace& space) {
  switch (overlays.boxes) {
    case SpaceOverlays::Boxes::nodes:
      return NodeBoxLines(world, space, overlays.box_level);
    case SpaceOverlays::Boxes::accelerator:
      return AcceleratorBoxLines(accelerator, space, overlays.box_level);
    case SpaceOverlays::Boxes::none:
      break;
  }
  return {};
}

std::string BoxesInWords(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                         const DrawingSpace& space) {
  if (overlays.boxes == SpaceOverlays::Boxes::none) return "no boxes";
  const std::string level =
      overlays.box_level == all_levels ? "of all levels" : "of level " + std::to_string(overlays.box_level);
  const BoxLines boxes = LinesOfBoxes(overlays, world, accelerator, space);
  return std::to_string(boxes.boxes) + (boxes.boxes == 1 ? " box" : " boxes") +
         (overlays.boxes == SpaceOverlays::Boxes::nodes ? " of nodes " : " of the accelerator ") + level +
         (boxes.left_out > 0 ? ", " + std::to_string(boxes.left_out) + " left out" : "");
}

}  // namespace ray

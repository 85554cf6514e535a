#pragma once

#include <cstdint>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/scene/Camera.h"
#include "source/view/Drawing.h"

/// What is drawn over a scene as lines.
namespace ray {

/// Boxes, 12 lines each; with very many of them only the first.
struct BoxLines {
  Lines lines;
  std::int64_t boxes = 0;     // drawn
  std::int64_t left_out = 0;  // beyond most_boxes
};
inline constexpr std::int64_t most_boxes = 200'000;  // 77 MB of vertices
inline constexpr int all_levels = -1;

/// How deep the scene graph is: 1 for a root alone.
int GraphLevels(const World& world);
/// Nodes with a box at a level, the root's 0, or at all_levels.
std::int64_t CountNodeBoxes(const World& world, int level);
/// Their boxes, each with the axes of the node's parent: slanted ones where a group above turns. Boxes of what moves
/// are around all of its own way, as the tracer uses them, and where their parent is when the shutter opens.
BoxLines NodeBoxLines(const World& world, const DrawingSpace& space, int level);

/// The boxes that an accelerator keeps, at a level or at all_levels; see Accelerator::BoxesAt.
BoxLines AcceleratorBoxLines(const Accelerator& accelerator, const DrawingSpace& space, int level);

/// A hue for each level, far from those of the levels next to it.
Rgba LevelColor(int level);

/// The eye, its directions of view through the corners of a picture, and that picture `distance` away, its upper edge
/// marked.
Lines CameraLines(const Camera& camera, int width, int height, double distance, const DrawingSpace& space,
                  const Rgba& color);

/// Every light that is not black, in its colour: a star where it is, circles around the sphere that holds it, an arrow
/// where it shines more one way than others; for one at infinity an arrow into the scene.
Lines LightLines(const Scene& scene, const DrawingSpace& space);

/// The lines that the scene itself asks for, in the colour of their material.
Lines SceneLineLines(const World& world, const DrawingSpace& space);

/// x red, y green, z blue; `size` in the world.
Lines AxesAt(const R3::Point& p, double size, const DrawingSpace& space);
/// Three short lines that cross.
Lines CrossAt(const R3::Point& p, double size, const DrawingSpace& space, const Rgba& color);
/// A line with a head, from `p` to `p` + `way`.
Lines ArrowAt(const R3::Point& p, const R3::Vector& way, const DrawingSpace& space, const Rgba& color);

}  // namespace ray

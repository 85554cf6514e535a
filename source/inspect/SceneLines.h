#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/draw/Drawing.h"
#include "source/scene/Camera.h"

namespace ray {

// Lines drawn over a scene.

/// Bounding boxes, 12 lines each, up to a limit. The more boxes, the fainter they are.
struct BoxLines {
  Lines lines;
  std::int64_t boxes = 0;     // drawn
  std::int64_t left_out = 0;  // beyond most_boxes
};
inline constexpr std::int64_t most_boxes = 200'000;  // 77 MB of vertices
inline constexpr int all_levels = -1;

/// The boxes of the nodes of the scene graph at a level, the root's 0, or at all_levels; each with the axes of the
/// node's parent: rotated ones below a group that rotates. Boxes of moving nodes enclose their whole motion, as in
/// tracing, at the position of their parent when the shutter opens.
BoxLines NodeBoxLines(const World& world, const DrawingSpace& space, int level);

/// Returns the parent of each node, as an index into World::Nodes; their number for the root.
std::vector<std::size_t> ParentsOf(const World& world);

/// The frame that the bounds of a node are in: its parent's. `node`: an index into World::Nodes.
std::uint32_t FrameAround(const World& world, std::size_t node);

/// The box of one node, an index into World::Nodes; likewise. No lines for an empty box.
Lines NodeBoxOf(const World& world, const DrawingSpace& space, std::size_t node, const Rgba& color);

/// The bounding boxes of an accelerator at a level or at all_levels; see Accelerator::BoxesAt.
BoxLines AcceleratorBoxLines(const Accelerator& accelerator, const DrawingSpace& space, int level);

/// A hue for each level, far from those of the levels next to it.
Rgba LevelColor(int level);

/// The eye, its directions of view through the corners of an image, and that image `distance` away, its upper edge
/// marked.
Lines CameraLines(const Camera& camera, int width, int height, double distance, const DrawingSpace& space,
                  const Rgba& color);

/// Every light that is not black, in its color: a star at its position, circles around its bounding sphere, an arrow
/// for its direction and, if it is outside of the scene, a faint line to the scene's middle; for a light at infinity an
/// arrow into the scene.
Lines LightLines(const Scene& scene, const DrawingSpace& space);

/// The lines that the scene itself contains, in the color of their material.
Lines SceneLineLines(const World& world, const DrawingSpace& space);

/// x red, y green, z blue; `size` in the world.
Lines AxesAt(const R3::Point& p, double size, const DrawingSpace& space);
/// Three short crossing lines.
Lines CrossAt(const R3::Point& p, double size, const DrawingSpace& space, const Rgba& color);
/// An arrow from `p` to `p` + `way`.
Lines ArrowAt(const R3::Point& p, const R3::Vector& way, const DrawingSpace& space, const Rgba& color);

/// The overlays in the space of the scene.
struct SpaceOverlays {
  enum class Boxes { none, nodes, accelerator };

  bool faces = true, edges = false, camera = false, lights = false;
  bool quad = true;     // the rendered image in space, if any
  bool shadows = true;  // of the preview, if the scene has lights
  Boxes boxes = Boxes::none;
  int box_level = all_levels;
};

/// The visible boxes, as lines.
BoxLines LinesOfBoxes(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                      const DrawingSpace& space);
std::string DescribeBoxes(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                          const DrawingSpace& space);

}  // namespace ray

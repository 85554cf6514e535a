#pragma once

#include <cstdint>

#include "source/accelerate/World.h"
#include "source/view/Drawing.h"

namespace ray {

/// How much may be drawn. Shapes that are not meshes are tessellated the more coarsely, the more of them there are.
struct PictureBudget {
  std::int64_t quick_triangles = 40'000;     // up to here more finely than the outline needs
  std::int64_t usual_triangles = 2'000'000;  // up to here as finely as the outline needs
  std::int64_t most_vertices = 12'000'000;   // 4 million triangles of flat meshes, or 1.5 million boxes: some 300 MB
};

/// How far from the scene's middle what has no end is drawn, in radii of the scene.
inline constexpr double times_the_scene = 10;

/// A scene as lit triangles, and how much of it is missing.
struct ScenePicture {
  Triangles triangles;
  std::int64_t primitives = 0;  // of the scene
  std::int64_t as_boxes = 0;    // of these shown as their bounding boxes, because there are too many
  std::int64_t left_out = 0;    // of these not shown at all, for the same reason; evenly spread
};

/// The scene shaded as the course's viewer does it, not as it is rendered: at each vertex
///     emission + ka ambient + kd texture * sum over lights of irradiance |N.L|,
/// without shadows, highlights and environment, lit on both sides, interpolated between vertices. Area and sphere
/// lights are sampled at one point. The alpha of transparent surfaces is 1 - luminance(kt). What moves is where it is
/// when the shutter opens. Of very many lights only as many as time allows are used, evenly chosen and weighted up.
ScenePicture PictureOf(const World& world, const DrawingSpace& space, const PictureBudget& budget = {});

}  // namespace ray

#pragma once

#include <cstdint>

#include "source/accelerate/World.h"
#include "source/view/Drawing.h"

namespace ray {

/// How much may be drawn.
struct PictureBudget {
  std::int64_t quick_triangles = 40'000;  // up to here things are drawn more finely than the eye needs for shape alone
  std::int64_t usual_triangles = 2'000'000;  // round shapes are drawn the coarser, the more of them there are
  std::int64_t most_vertices = 12'000'000;   // 4 million triangles of flat meshes, or 1.5 million boxes: some 300 MB
};

/// All of a scene as triangles in the light of its lamps, and what of it is not there.
struct ScenePicture {
  Triangles triangles;
  std::int64_t primitives = 0;  // of the scene
  std::int64_t as_boxes = 0;    // of these shown as no more than their boxes, because there are too many
  std::int64_t left_out = 0;    // of these not shown at all, for the same reason; evenly spread among them
};

/// The scene as the course's viewer shows it, which is not how rays see it: at each corner
///     emission + ka ambient + kd texture * sum over lights of irradiance |N.L|,
/// without shadows, highlights and environment, surfaces lit on both sides, between corners blended. Of area and sphere
/// lights one place shines for all. Clear surfaces cover 1 - luminance(kt). What moves is where it is when the shutter
/// opens. With very many lights only as many as time allows, evenly chosen, shine for all.
ScenePicture PictureOf(const World& world, const DrawingSpace& space, const PictureBudget& budget = {});

}  // namespace ray

#pragma once

#include <cstdint>

#include "source/render/RenderSettings.h"
#include "source/view/preview/DiffuseLight.h"
#include "source/view/preview/PreviewLights.h"
#include "source/view/preview/Surfaces.h"

namespace ray {

/// How much may be drawn. Shapes that are not meshes are tessellated the more coarsely, the more of them there are.
struct PictureBudget {
  std::int64_t quick_triangles = 40'000;     // up to here more finely than the outline needs
  std::int64_t usual_triangles = 2'000'000;  // up to here as finely as the outline needs
  std::int64_t most_vertices = 12'000'000;   // 4 million triangles of flat meshes, or 1.5 million boxes: some 400 MB
};

/// How far from the scene's middle what has no end is drawn, in radii of the scene.
inline constexpr double times_the_scene = 10;

/// A scene as triangles, with what lights them, and how much of it is missing.
struct ScenePicture {
  Surfaces surfaces;
  PreviewLights lights;
  DiffuseLight diffuse_light;                      // of the environment; in mode path also of the background
  R2::Color background;                            // seen where there is no environment
  std::shared_ptr<const Environment> environment;  // null for none
  bool fresnel = false;                            // as in TraceSettings
  std::int64_t primitives = 0;                     // of the scene
  std::int64_t as_boxes = 0;                       // of these shown as their bounding boxes, because there are too many
  std::int64_t left_out = 0;                       // of these not shown at all, for the same reason; evenly spread
};

/// The scene, to be shaded at each pixel by the formulas of the tracer's modes whitted and path, but without rays: no
/// shadows, and mirrors show the environment or the background alone. Clear surfaces let through what is behind them
/// straight on, or bend what comes from the environment as a ball would. What their inside absorbs is that of 2/3 of
/// the smallest side of each shape's box, which is the mean way through a ball. What moves is where it is when the
/// shutter opens.
ScenePicture PictureOf(const World& world, const RenderSettings& settings, const DrawingSpace& space,
                       const PictureBudget& budget = {});

}  // namespace ray

#pragma once

#include <cstdint>
#include <limits>

#include "source/draw/preview/DiffuseLight.h"
#include "source/draw/preview/PreviewLights.h"
#include "source/draw/preview/Surfaces.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// How much may be drawn. Shapes that are not meshes are tessellated the more coarsely, the more of them there are.
struct PictureBudget {
  std::int64_t quick_triangles = 40'000;     // up to here more finely than the outline needs
  std::int64_t usual_triangles = 2'000'000;  // up to here as finely as the outline needs
  std::int64_t most_vertices = 12'000'000;   // 4 million triangles of flat meshes, or 1.5 million boxes: some 400 MB
  std::int64_t mesh_triangles = std::numeric_limits<std::int64_t>::max();  // of all meshes; above, they are simplified
};

/// What a renderer in software draws in some 20 ms.
inline constexpr PictureBudget budget_in_motion{0, 60'000, 1'000'000, 60'000};

/// How far from the scene's middle what has no end counts as part of the drawing, in radii of the scene. It is drawn
/// beyond that, up to where a screen shows no step to the horizon.
inline constexpr double times_the_scene = 10;

/// Colors of modes that show no light, as TraceSettings has them.
struct ModeLook {
  RenderMode mode = RenderMode::whitted;
  GoochTones gooch;
  int toon_bands = 3;
  ZBufferRange depths;  // of modes zbuffer and depth; both 0: of what is seen
};

/// Whether the preview shows the mode, and not light instead of it.
bool IsPreviewed(RenderMode mode);
/// Whether a mode shows the background where there is no surface.
bool ShowsBackground(RenderMode mode);
/// Whether the mode shows how far away surfaces are.
inline bool ShowsDepth(RenderMode mode) { return mode == RenderMode::zbuffer || mode == RenderMode::depth; }

/// A scene as triangles, with what lights them, and how much of it is missing.
struct ScenePicture {
  Surfaces surfaces;
  PreviewLights lights;
  DiffuseLight diffuse_light;                      // of the environment; in mode path also of the background
  R2::Color background;                            // seen where there is no environment
  std::shared_ptr<const Environment> environment;  // null for none
  bool fresnel = false;                            // as in TraceSettings
  bool shadows = true;                             // likewise
  int mirror_bounces = 0;                          // of mirrors that show mirrors
  ModeLook look;
  std::int64_t primitives = 0;  // of the scene
  std::int64_t as_boxes = 0;    // of these shown as their bounding boxes, because there are too many
  std::int64_t left_out = 0;    // of these not shown at all, for the same reason; evenly spread
};

/// The scene, to be shaded at each pixel by the formulas of the tracer's modes, but without rays. Mirrors show what a
/// probe sees from the middle of their object, which up to most_mirror_probes of them have, the largest, and others
/// share with the nearest. Clear surfaces let through what is behind them straight on, or bend what the probe or the
/// environment sees as a ball would. What their inside absorbs is that of 2/3 of
/// the smallest side of each shape's box, which is the mean way through a ball. What moves is where it is when the
/// shutter opens.
ScenePicture PictureOf(const World& world, const RenderSettings& settings, const DrawingSpace& space,
                       const PictureBudget& budget = {});

}  // namespace ray

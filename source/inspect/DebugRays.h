#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "source/draw/Drawing.h"
#include "source/render/PixelTrace.h"

/// The renderer's rays, shown in space.
namespace ray {

/// Kinds that are shown or hidden together.
enum class ShownRays { camera, shadow, reflection, transmission };
inline constexpr std::size_t shown_ray_kinds = 4;

struct RayLook {
  std::array<bool, shown_ray_kinds> shows{true, true, true, true};
  bool normals = false;  // where rays end
  int deepest = -1;      // bounces; -1: all
  /// The number of a ray among those of one pixel. It is shown regardless of its kind; others are fainter, except those
  /// that lead to it.
  std::optional<std::size_t> chosen{};

  /// Draws the rays of other pixels.
  RayLook WithoutChoice() const {
    RayLook look = *this;
    look.chosen.reset();
    return look;
  }
};

/// Returns the colors in which RayLines draws them; the second one of shadow rays is for the part beyond what blocks
/// them.
std::vector<Rgba> ColorsOf(ShownRays kind);
Rgba ColorOfNormals();

inline constexpr int debug_ray_spacing = 25;  // pixels whose column and row are multiples of it

/// The numbers of rays that are traced for inspection.
struct DebugRayCounts {
  int camera = 1;   // samples of a pixel, >= 1; at most those of the settings count
  int shadow = 1;   // rays to each light, >= 1; likewise
  int in_cut = 50;  // pixels of the cross section's row that are traced, evenly spread, >= 1
  friend bool operator==(const DebugRayCounts&, const DebugRayCounts&) = default;

  /// The settings with few shadow rays.
  RenderSettings Thinned(RenderSettings settings) const;
  /// Returns the number of samples of a pixel that are traced.
  int SamplesOf(const RenderSettings& settings) const { return std::min(camera, settings.samples); }
};

/// The rays of the first sample of the pixels whose column and row are multiples of `spacing`.
std::vector<PixelTrace> TraceGrid(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                  int spacing = debug_ray_spacing);

/// Rays as lines, in a color for each kind. A blocked shadow ray is dark beyond what blocks it; a ray that hits nothing
/// is two radii of the scene long. The more rays, the fainter each.
Lines RayLines(const std::vector<PixelTrace>& traces, const DrawingSpace& space, const RayLook& look);

/// Rays of another tracer in one color, with a cross at the end of the one that differs from ours, if any.
Lines ForeignLines(const PixelTrace& foreign, const DrawingSpace& space, std::optional<std::size_t> differs);
Rgba ColorOfForeign();

/// The chosen ray of a pixel, in its color, with a cross at its end; empty if none is chosen.
Lines ChosenRay(const PixelTrace& trace, const DrawingSpace& space, const RayLook& look);

/// Rays as an .obj file of lines, grouped by kind, in the world.
std::string RaysAsObj(const std::vector<PixelTrace>& traces, double scene_radius);

}  // namespace ray

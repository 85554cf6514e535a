#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/parse/Text.h"
#include "source/render/PixelTrace.h"

/// Rays of another tracer, such as a student's, shown with ours.
namespace ray {

/// A ray of another tracer: from its start to where it ends.
struct ForeignRay {
  RayKind kind = RayKind::camera;
  R3::Point from, to;
};

/// A pixel, its row counted from the bottom.
struct ForeignPixel {
  int column = 0, row = 0;
};

/// Rays of one pixel, in the order of the file.
struct ForeignRays {
  std::optional<ForeignPixel> pixel;  // if the file has it
  std::vector<ForeignRay> rays;
};

/// Reads rays, one per line, "kind x y z x y z", with an optional weight that is not used, a line "pixel column row"
/// where the pixel is known, and # for comments; or an .obj file of lines grouped by kind, as RaysAsObj writes it.
/// Throws SceneErrors that point at each mistake.
ForeignRays ReadForeignRays(const Text& text);

/// Returns true if a file contains such rays: its name ends with .rays, or with .obj and its first group is a kind.
bool IsForeignRays(const Text& text);

/// The tolerances of FirstDifference.
inline constexpr double foreign_degrees = 1;    // between directions; of camera rays as much as the pixel is wide
inline constexpr double foreign_length = 5e-3;  // of places, in radii of the scene

/// The difference of another tracer's rays from ours.
struct RayDifference {
  std::size_t foreign = 0;          // the ray that differs, or at whose end a ray is missing
  std::optional<std::size_t> ours;  // the ray compared with it
  std::string text;                 // "reflection ray at depth 1: ..."
};

/// Finds the first ray, bounce by bounce, that differs from ours by more than the tolerances above, and names the
/// mistake that explains the difference, if known. Returns std::nullopt if all rays agree. Diffuse rays, which are
/// random, are not compared.
std::optional<RayDifference> FirstDifference(const PixelTrace& ours, const std::vector<ForeignRay>& foreign,
                                             const World& world, const RenderSettings& settings);

/// Returns the pixel of the rays: as given in the file, or the one through which the first camera ray of a pinhole
/// passes. std::nullopt if that is not in the image.
std::optional<ForeignPixel> PixelOf(const ForeignRays& foreign, const Camera& camera, const RenderSettings& settings);

/// Returns the same rays in the form of ours, each with the ray at whose end it starts.
PixelTrace AsTrace(const std::vector<ForeignRay>& foreign, double scene_radius);

}  // namespace ray

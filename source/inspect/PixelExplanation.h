#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/inspect/LoadedScene.h"
#include "source/render/PixelTrace.h"

namespace ray {

/// Returns what a ray hits, "sphere, line 16"; empty if it hits nothing.
std::string HitBy(const RecordedRay& ray, const World& world);

/// Returns the light that each ray of a pixel brings, with all rays that come from it.
std::vector<R2::Color> SubtreeLight(const PixelTrace& pixel);

/// The explanation why a pixel differs from a reference.
struct PixelExplanation {
  std::optional<std::size_t> ray;  // whose light makes the difference; nothing for a setting
  std::string text;
};

/// Finds the one ray whose light, omitted or counted twice, or the one setting that, changed, brings a pixel nearest
/// to the reference. Nothing where the pixel is right within half of 1/255 in each channel, or where more than a tenth
/// of the difference would be left.
///   settings   those that the pixel was traced with
std::optional<PixelExplanation> ExplainPixel(const PixelTrace& pixel, const R2::Color& reference,
                                             const LoadedScene& scene, const RenderSettings& settings);

}  // namespace ray

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/inspect/LoadedScene.h"
#include "source/render/PixelTrace.h"

namespace ray {

/// Returns what a ray hits, "sphere, line 16"; empty if it hits nothing.
std::string HitBy(const RecordedRay& ray, const World& world);

/// Returns the light that each ray of a pixel contributes, including that of the rays that follow from it.
std::vector<R2::Color> SubtreeLight(const PixelTrace& pixel);

/// The explanation why a pixel differs from a reference.
struct PixelExplanation {
  std::optional<std::size_t> ray;  // whose light makes the difference; std::nullopt for a setting
  std::string text;
};

/// Finds the one ray whose light, omitted or counted twice, or the one setting that, changed, brings a pixel nearest
/// to the reference. Returns std::nullopt if the pixel is right within half of 1/255 in each channel, or if more than a
/// tenth of the difference would remain.
///   settings   those of the traced pixel
std::optional<PixelExplanation> ExplainPixel(const PixelTrace& pixel, const R2::Color& reference,
                                             const LoadedScene& scene, const RenderSettings& settings);

}  // namespace ray

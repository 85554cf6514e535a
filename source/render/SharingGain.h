#pragma once

#include <atomic>
#include <optional>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Returns true if the paths of a render share light; std::nullopt if that depends on a pilot render.
std::optional<bool> SharesLight(const RenderSettings& settings);

/// Returns true if the settings request it, or if a pilot render shows that it gains enough.
///   stop   a request to end the pilot render; the result is then arbitrary; may be null
bool SharesLight(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                 const std::atomic<bool>* stop = nullptr);

/// Returns the gain in efficiency from sharing light: the variance without it over that with it, divided by the same
/// ratio of counted rays, in which a shadow ray counts as half of another. Traces some 4,000 paths, spread over the
/// whole image, or a fourth of these if they gain little; the same for any number of samples and on any machine.
///   accuracy   some 20% of the ratio of linear relative variances
double SharingGain(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                   const std::atomic<bool>* stop = nullptr);

}  // namespace ray

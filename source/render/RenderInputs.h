#pragma once

#include <memory>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/integrate/CameraRays.h"
#include "source/integrate/Integrator.h"
#include "source/render/RenderSettings.h"

namespace ray {

// The inputs of Render, for callers that take samples in another order. None except the film depends on the requested
// part of the image.

/// Returns the camera of the settings, by default the scene's.
Camera CameraOf(const World& world, const RenderSettings& settings);
std::unique_ptr<const Integrator> IntegratorOf(const World& world, const Accelerator& accelerator,
                                               const RenderSettings& settings);
TraceSettings TraceSettingsOf(const RenderSettings& settings);
CameraRays CameraRaysOf(const World& world, const RenderSettings& settings);
/// Returns camera rays that are laid out for another number of samples per pixel than the settings plan.
CameraRays CameraRaysOf(const World& world, const RenderSettings& settings, std::uint32_t samples);
Film EmptyFilmOf(const RenderSettings& settings);

/// Estimates the number of rays of a render, or of the part of it that settings.part names, before it begins.
double ExpectedRays(const RenderSettings& settings);

}  // namespace ray

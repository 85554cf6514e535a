#pragma once

#include <array>
#include <memory>

#include "source/integrate/Integrator.h"

namespace ray {

/// What a picture can show.
///   whitted   the course's recursion
///   path      distributed ray tracing with light over many bounces
///   heat      what each pixel cost to trace in mode whitted: nodes and primitives looked at
///   rays      how many rays each pixel took in mode whitted
///   others    the first surface: see FirstHit
enum class RenderMode { whitted, path, heat, rays, depth, normal, uv, albedo, id };
inline constexpr std::array render_modes{"whitted", "path", "heat", "rays", "depth", "normal", "uv", "albedo", "id"};
constexpr const auto& NamesOf(RenderMode) { return render_modes; }

/// Whether a mode shows costs, in the colors of HeatColor, rather than light or surfaces.
inline bool ShowsCosts(RenderMode mode) { return mode == RenderMode::heat || mode == RenderMode::rays; }

/// The integrator of a mode.
std::unique_ptr<const Integrator> MakeIntegrator(RenderMode mode, const World& world, const Accelerator& accelerator,
                                                 const TraceSettings& settings);

}  // namespace ray

#pragma once

#include <array>
#include <memory>
#include <string>

#include "source/integrate/Integrator.h"

namespace ray {

/// What a picture can show.
///   whitted   the course's recursion
///   path      distributed ray tracing with light over many bounces
///   heat      what each pixel cost to trace in mode whitted: nodes and primitives looked at
///   rays      how many rays each pixel took in mode whitted
///   others    the first surface: see FirstHit
inline constexpr std::array render_modes{"whitted", "path", "heat", "rays", "depth", "normal", "uv", "albedo", "id"};

/// Whether a mode shows costs, in the colours of HeatColor, rather than light or surfaces.
inline bool ShowsCosts(const std::string& mode) { return mode == "heat" || mode == "rays"; }

/// The integrator of a mode, which is one of the above.
std::unique_ptr<const Integrator> MakeIntegrator(const std::string& mode, const World& world,
                                                 const Accelerator& accelerator, const TraceSettings& settings);

}  // namespace ray

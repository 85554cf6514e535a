#pragma once

#include <array>
#include <memory>
#include <string>

#include "source/integrate/Integrator.h"

namespace ray {

/// What a picture can show.
///   whitted   the course's recursion
///   path      distributed ray tracing with light over many bounces
///   heat      what each pixel cost to trace in mode whitted
///   others    the first surface: see FirstHit
inline constexpr std::array render_modes{"whitted", "path", "heat", "depth", "normal", "uv", "albedo", "id"};

/// The integrator of a mode, which is one of the above.
std::unique_ptr<const Integrator> MakeIntegrator(const std::string& mode, const World& world,
                                                 const Accelerator& accelerator, const TraceSettings& settings);

}  // namespace ray

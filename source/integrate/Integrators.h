#pragma once

#include <array>
#include <span>

#include "source/integrate/Integrator.h"

namespace ray {

/// What a picture can show: the lines of integrators.def.
enum class RenderMode {
#define INTEGRATOR(name) name,
#include "source/integrate/integrators.def"
#undef INTEGRATOR
};
inline constexpr std::array render_modes{
#define INTEGRATOR(name) #name,
#include "source/integrate/integrators.def"
#undef INTEGRATOR
};
constexpr const auto& NamesOf(RenderMode) { return render_modes; }

/// Every kind, in the order of integrators.def.
std::span<const IntegratorKind* const> IntegratorKinds();
const IntegratorKind& KindOf(RenderMode mode);

/// Whether a mode shows costs, in the colors of HeatColor, rather than light or surfaces.
inline bool ShowsCosts(RenderMode mode) { return KindOf(mode).shows_costs; }

/// Whether the lights of the scene bear on what a mode shows.
inline bool ShowsLight(RenderMode mode) {
  return mode == RenderMode::whitted || mode == RenderMode::path || mode == RenderMode::gooch ||
         mode == RenderMode::toon || mode == RenderMode::hatching;
}

/// The integrator of a mode, with outlines where the settings ask for them.
std::unique_ptr<const Integrator> MakeIntegrator(RenderMode mode, const World& world, const Accelerator& accelerator,
                                                 const TraceSettings& settings);

}  // namespace ray

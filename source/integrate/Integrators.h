#pragma once

#include <array>
#include <span>

#include "source/integrate/Integrator.h"

namespace ray {

/// The modes of an image: the lines of integrators.def.
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

/// Returns all kinds, in the order of integrators.def.
std::span<const IntegratorKind* const> IntegratorKinds();
const IntegratorKind& KindOf(RenderMode mode);

/// Returns true if a mode shows costs, in the colors of HeatColor, instead of light or surfaces.
inline bool ShowsCosts(RenderMode mode) { return KindOf(mode).shows_costs; }

/// Returns true if a mode depends on the lights of the scene.
inline bool ShowsLight(RenderMode mode) {
  return mode == RenderMode::whitted || mode == RenderMode::path || mode == RenderMode::gooch ||
         mode == RenderMode::toon || mode == RenderMode::hatching;
}

/// Creates the integrator of a mode, with outlines if the settings request them.
std::unique_ptr<const Integrator> MakeIntegrator(RenderMode mode, const World& world, const Accelerator& accelerator,
                                                 const TraceSettings& settings);

}  // namespace ray

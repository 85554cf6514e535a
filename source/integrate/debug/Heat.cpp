#include "source/integrate/debug/Heat.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "source/integrate/Whitted.h"

namespace ray {

double Heat(const Counts& cost) { return static_cast<double>(cost.node_visits + cost.primitive_tests); }

R2::Color HeatColor(double heat) {
  static const std::array<R2::Color, 5> scale{R2::Color{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
  const double decades = std::clamp(std::log10(std::max(heat, 1.0)), 0.0, static_cast<double>(scale.size() - 1));
  const auto below = std::min(static_cast<std::size_t>(decades), scale.size() - 2);
  const double share = decades - static_cast<double>(below);
  return (1 - share) * scale[below] + share * scale[below + 1];
}

namespace {

std::unique_ptr<const Integrator> MakeWhitted(const World& world, const Accelerator& accelerator,
                                              const TraceSettings& settings) {
  return std::make_unique<Whitted>(world, accelerator, settings);
}

}  // namespace

extern const IntegratorKind heat_kind{"what each pixel cost in mode whitted: nodes and primitives looked at",
                                      MakeWhitted, true};
extern const IntegratorKind rays_kind{"how many rays each pixel took in mode whitted", MakeWhitted, true};

}  // namespace ray

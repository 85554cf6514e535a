#include "source/integrate/debug/Heat.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "R1/Elementary.h"
#include "source/integrate/Whitted.h"

namespace ray {

double Heat(const Counts& cost) { return static_cast<double>(cost.node_visits + cost.primitive_tests); }

void CostIntegrator::Li(std::span<const CameraSample> samples, std::span<R2::Color> costs, TraceState& state) const {
  const auto cost_so_far = [&] {
    return counts_rays_ ? static_cast<double>(state.rays.Total()) : Heat(state.rays.Cost());
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double before = cost_so_far();
    traced_->Li(samples.subspan(i, 1), costs.subspan(i, 1), state);
    const double cost = cost_so_far() - before;
    costs[i] = {cost, cost, cost};
  }
}

R2::Color HeatColor(double heat) {
  static const std::array<R2::Color, 5> scale{R2::Color{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
  const double decades = std::clamp(R1::Log10(std::max(heat, 1.0)), 0.0, static_cast<double>(scale.size() - 1));
  const auto below = std::min(static_cast<std::size_t>(decades), scale.size() - 2);
  const double share = decades - static_cast<double>(below);
  return (1 - share) * scale[below] + share * scale[below + 1];
}

namespace {

template <bool counts_rays>
std::unique_ptr<const Integrator> MakeCost(const World& world, const Accelerator& accelerator,
                                           const TraceSettings& settings) {
  return std::make_unique<CostIntegrator>(std::make_unique<Whitted>(world, accelerator, settings), counts_rays);
}

}  // namespace

extern const IntegratorKind heat_kind{"what each pixel cost in mode whitted: nodes and primitives looked at",
                                      MakeCost<false>, true};
extern const IntegratorKind rays_kind{"how many rays each pixel took in mode whitted", MakeCost<true>, true};

}  // namespace ray

#include "source/integrate/debug/Heat.h"

#include <algorithm>
#include <array>
#include <limits>

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

namespace {

constexpr std::array<R2::Color, 5> heat_scale{R2::Color{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};

R2::Color OnScale(std::size_t below, double share) {
  return (1 - share) * heat_scale[below] + share * heat_scale[below + 1];
}

double Dot(const R2::Color& a, const R2::Color& b) { return a.r * b.r + a.g * b.g + a.b * b.b; }

}  // namespace

R2::Color HeatColor(double heat) {
  const double decades = std::clamp(R1::Log10(std::max(heat, 1.0)), 0.0, static_cast<double>(heat_scale.size() - 1));
  const auto below = std::min(static_cast<std::size_t>(decades), heat_scale.size() - 2);
  return OnScale(below, decades - static_cast<double>(below));
}

double HeatOf(const R2::Color& color) {
  double nearest = std::numeric_limits<double>::infinity(), decades = 0;
  for (std::size_t below = 0; below + 1 < heat_scale.size(); ++below) {
    const R2::Color way = heat_scale[below + 1] - heat_scale[below], to = color - heat_scale[below];
    const double share = std::clamp(Dot(to, way) / Dot(way, way), 0.0, 1.0);
    const R2::Color off = color - OnScale(below, share);
    if (!(Dot(off, off) < nearest)) continue;
    nearest = Dot(off, off);
    decades = static_cast<double>(below) + share;
  }
  return R1::Pow(10, decades);
}

namespace {

template <bool counts_rays>
std::unique_ptr<const Integrator> MakeCost(const World& world, const Accelerator& accelerator,
                                           const TraceSettings& settings) {
  return std::make_unique<CostIntegrator>(std::make_unique<Whitted>(world, accelerator, settings), counts_rays);
}

}  // namespace

extern const IntegratorKind heat_kind{"cost per pixel in mode whitted: nodes visited plus primitives tested",
                                      MakeCost<false>, true};
extern const IntegratorKind rays_kind{"rays traced per pixel in mode whitted", MakeCost<true>, true};

}  // namespace ray

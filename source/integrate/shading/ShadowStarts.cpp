#include "source/integrate/shading/ShadowStarts.h"

#include "R3/Numeric.h"

namespace ray {
namespace {

template <typename NormalOf, typename ClearanceOf>
[[gnu::always_inline]] inline void MakeEach(const NormalOf& N, const ClearanceOf& clearance,
                                            const LightSamples& samples, ShadowStarts& __restrict starts) {
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const R3::Vector to_light = samples.to_light[i];
    starts.begin[i] = R3::Departure::BeginTowards(clearance(i), to_light);
    starts.facing[i] = Dot(N(i), to_light);
  }
}

[[gnu::noinline]] void BeginAt(double bias, const LightSamples& samples, ShadowStarts& starts) {
  for (std::uint32_t i = 0; i < samples.count; ++i) starts.begin[i] = bias / Length(samples.to_light[i]);
}

}  // namespace

R3_VECTORIZED
void MakeShadowStarts(const R1::Columns<R3::Vector>& N, const LightSamples::Each& clearance, double bias,
                      const LightSamples& samples, ShadowStarts& starts) {
  MakeEach([&](std::uint32_t i) { return N[i]; }, [&](std::uint32_t i) { return clearance[i]; }, samples, starts);
  if (bias > 0) [[unlikely]]
    BeginAt(bias, samples, starts);
}

R3_VECTORIZED
void MakeShadowStarts(const ShadingPoint& p, const LightSamples& samples, ShadowStarts& starts) {
  const R3::Vector N = p.N;
  const double clearance = p.departure.clearance;
  MakeEach([=](std::uint32_t) { return N; }, [=](std::uint32_t) { return clearance; }, samples, starts);
  if (p.bias > 0) [[unlikely]]
    BeginAt(p.bias, samples, starts);
}

}  // namespace ray

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

R3_VECTORIZED
void MakeOfOne(const R3::Vector& N, double clearance, const LightSamples& samples, ShadowStarts& starts) {
  const R3::Vector normal = N;
  MakeEach([&](std::uint32_t) { return normal; }, [&](std::uint32_t) { return clearance; }, samples, starts);
}

R3_VECTORIZED
void MakeOfMany(const R1::Columns<R3::Vector>& N, const LightSamples::Each& clearance, const LightSamples& samples,
                ShadowStarts& starts) {
  MakeEach([&](std::uint32_t i) { return N[i]; }, [&](std::uint32_t i) { return clearance[i]; }, samples, starts);
}

void BeginAt(double bias, const LightSamples& samples, ShadowStarts& starts) {
  if (bias > 0) [[unlikely]]
    for (std::uint32_t i = 0; i < samples.count; ++i) starts.begin[i] = bias / Length(samples.to_light[i]);
}

}  // namespace

void MakeShadowStarts(const R1::Columns<R3::Vector>& N, const LightSamples::Each& clearance, double bias,
                      const LightSamples& samples, ShadowStarts& starts) {
  MakeOfMany(N, clearance, samples, starts);
  BeginAt(bias, samples, starts);
}

void MakeShadowStarts(const ShadingPoint& p, const LightSamples& samples, ShadowStarts& starts) {
  MakeOfOne(p.N, p.departure.clearance, samples, starts);
  BeginAt(p.bias, samples, starts);
}

}  // namespace ray

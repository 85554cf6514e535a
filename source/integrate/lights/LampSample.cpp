#include "source/integrate/lights/LampSample.h"

#include <bit>

#include "source/sample/Sampler.h"

namespace ray {
namespace {

// A key beneath surfaces, beside those of lights, of which there are not as many.
constexpr std::uint64_t again_key = camera_key - 3;

}  // namespace

std::optional<LightSample> SampleLight(const ShadingPoint& p, const EmissiveShape& lamp, const R2::Point& u) {
  const R3::Point& from = p.free_point;
  const double time = p.path.ray.time;
  auto drawn = lamp.SampleTowards(from, u, time);
  if (!drawn && !lamp.DrawsInSight()) {
    // Of some shapes, what hides itself is drawn as well. The mean is that over what does not.
    constexpr std::uint32_t most_attempts = 64;
    const RandomKey key = p.path.index.key.Child(again_key).Child(std::bit_cast<std::uint64_t>(u.x));
    const Points again(SamplerKind::random, key.Child(std::bit_cast<std::uint64_t>(u.y)), most_attempts);
    for (std::uint32_t k = 0; k < most_attempts && !drawn; ++k) drawn = lamp.SampleTowards(from, again.Get2D(k), time);
  }
  if (!drawn) return {};
  return LightSample{.irradiance = drawn->radiance, .to_light = drawn->towards, .reaching = lamp.Reached()};
}

}  // namespace ray

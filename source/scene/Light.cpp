#include "source/scene/Light.h"

#include <array>

#include "R1/Kinds.h"

namespace ray {

void Light::IlluminateEach(LightSamples& samples) const {
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const LightSample sample = Illuminate(samples.from[i], samples.random[i]).value_or(LightSample{});
    samples.Set(i, sample.to_light, sample.irradiance);
  }
}

std::span<const LightKind* const> LightKinds() {
#define LIGHT(name) KIND(LightKind, name##_kind),
  static const std::array kinds{
#include "source/scene/lights.def"
  };
  return kinds;
}

const LightKind* FindLightKind(const std::string& name) { return R1::FindKind(LightKinds(), name); }

std::vector<std::unique_ptr<const Light>> DefaultLights() {
  const LightKind& directional = *FindLightKind("dir_light");
  std::vector<std::unique_ptr<const Light>> lights;
  lights.push_back(directional.make(std::array{1.0, 1.0, 1.0, -3.0, -4.0, -5.0}));
  lights.push_back(directional.make(std::array{0.5, 0.5, 0.5, 3.0, 2.0, 3.0}));
  return lights;
}

}  // namespace ray

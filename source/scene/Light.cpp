#include "source/scene/Light.h"

#include <array>

#include "R1/Kinds.h"

namespace ray {

std::optional<LightSample> Light::Illuminate(const R3::Point& p, const R2::Point& random) const {
  LightSamples one;
  one.count = 1;
  one.from.Set(0, p), one.random.Set(0, random);
  IlluminateEach(one);
  if (R2::IsBlack(one.color[0])) return {};
  return LightSample{one.color[0], one.to_light[0], Bound().is_infinite};
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

#include "source/integrate/lights/Caustics.h"

#include <algorithm>

#include "source/integrate/shading/Bsdf.h"

namespace ray {

Caustics CausticsOf(const World& world, const TraceSettings& settings) {
  constexpr std::int64_t least_depth = 2;  // from the scattering to the reflecting surface, and on to the emissive one
  if (settings.max_depth < least_depth) return {};
  double scattered = 0, passed_on = 0, brightest = 0;  // largest fractions of light, and brightest emission
  const auto add = [&](const Instance& instance, const Material& material) {
    const bool is_glossy = IsGlossy(material, settings);
    scattered = std::max(scattered, Luminance(material.kd) + (is_glossy ? Luminance(material.kr) : 0));
    passed_on = std::max(passed_on, Luminance(material.kt) + (is_glossy ? 0 : Luminance(material.kr)));
    // Clear surfaces reflect more at grazing angles than kr.
    if (material.coat > 0 || (settings.fresnel && !IsBlack(material.kt))) passed_on = std::max(passed_on, 1.0);
    if (instance.Emits()) brightest = std::max(brightest, Luminance(material.emission));
  };
  for (const Instance& instance : world.Instances()) {
    add(instance, *instance.material);
    if (instance.has_parts)
      for (const Material* part : world.MaterialsOf(instance)) add(instance, *part);
  }
  if (!(scattered > 0 && passed_on > 0)) return {};
  if (const auto& environment = world.scene().environment) brightest = std::max(brightest, environment->Brightest());
  return {brightest, brightest * scattered * passed_on};
}

}  // namespace ray

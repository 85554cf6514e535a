#include "source/render/SceneFeatures.h"
#include "source/text/EnumNames.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace ray {
namespace {

std::string Text(double number) {
  std::array<char, 64> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return std::string(text.data(), end);
}

bool IsTraced(RenderMode mode) { return mode == RenderMode::whitted || mode == RenderMode::path || ShowsCosts(mode); }

}  // namespace

SceneFeatures FeaturesOf(const World& world, const RenderSettings& settings) {
  const Scene& scene = world.scene();
  SceneFeatures n;
  n.motion = settings.camera.HasMotion() || world.Moves();
  n.lens = settings.camera.HasLens();
  n.wide_filter = settings.filter != FilterKind::box;
  n.two_streams = settings.budget.error.has_value();
  if (!IsTraced(settings.mode)) return n;

  std::size_t lights = 0;
  for (const auto& light : scene.lights) {
    if (light->IsBlack()) continue;
    ++lights;
    n.lights = true;
    n.area_lights |= light->IsExtended();
  }
  n.environment = scene.environment && !scene.environment->IsBlack();
  for (const Instance& instance : world.Instances()) {
    const Material& m = *instance.material;
    if (!IsBlack(m.emission) && instance.mesh) {
      n.emissive_triangles = true;
      lights += static_cast<std::size_t>(instance.mesh->Elements());
    }
    n.mirrors |= !IsBlack(m.ks) && settings.trace.max_depth > 0;
    n.clear |= !IsBlack(m.kt) && settings.trace.max_depth > 0;
    n.bending |= !IsBlack(m.kt) && m.ir != 1 && settings.trace.max_depth > 0;
    n.absorbing |= !IsBlack(m.absorb);
    n.textures |= m.texture != nullptr;
  }
  n.choice_of_lights =
      lights > 1 && (settings.trace.lights > 0 || (settings.mode == RenderMode::path && settings.trace.lights < 0));
  return n;
}

std::vector<std::string> SceneFeatures::Names() const {
  const std::pair<bool, const char*> all[] = {{motion, "motion"},
                                              {lens, "lens"},
                                              {lights, "lights"},
                                              {area_lights, "area lights"},
                                              {emissive_triangles, "emissive triangles"},
                                              {environment, "environment"},
                                              {choice_of_lights, "choice of lights"},
                                              {mirrors, "mirrors"},
                                              {clear, "transmission"},
                                              {bending, "refraction"},
                                              {absorbing, "absorption"},
                                              {textures, "textures"},
                                              {wide_filter, "wide filter"},
                                              {two_streams, "two streams"}};
  std::vector<std::string> names;
  for (const auto& [is_needed, name] : all)
    if (is_needed) names.emplace_back(name);
  return names;
}

std::string KernelOf(const SceneFeatures& needs, const RenderSettings& settings) {
  return std::string(NameOf(settings.mode)) + ", " + (needs.motion ? "moving " : "") +
         (needs.lens ? "lens" : "pinhole") + ", " + NameOf(settings.filter) + " filter";
}

std::vector<std::string> BiasedSettings(const SceneFeatures& needs, const RenderSettings& settings) {
  std::vector<std::string> biased;
  if (!IsTraced(settings.mode)) return biased;
  const TraceSettings& trace = settings.trace;
  const bool is_path = settings.mode == RenderMode::path;
  const bool may_bounce = is_path || needs.mirrors || needs.clear;
  if (may_bounce || trace.max_depth == 0) biased.push_back("max_depth " + std::to_string(trace.max_depth));
  if (!is_path && may_bounce && trace.roulette != Roulette::on && trace.min_luminance > 0)
    biased.push_back("min_luminance " + Text(trace.min_luminance));
  if (!trace.shadows) biased.emplace_back("shadows off");
  if (settings.budget.error && settings.budget.adaptive != Adaptive::off) biased.emplace_back("adaptive tile");
  return biased;
}

}  // namespace ray

#include "source/render/SceneFeatures.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string_view>
#include <utility>

#include "source/integrate/lights/LightSource.h"
#include "source/integrate/lights/TriangleLamp.h"
#include "source/render/Schedule.h"
#include "source/text/EnumNames.h"

namespace ray {
namespace {

std::string SettingText(double number) {
  std::array<char, 64> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return std::string(text.data(), end);
}

/// Returns the number of lights of an emissive instance; 0 if it is not emissive or cannot be a light.
std::size_t LightsOf(const Instance& instance, const RenderSettings& settings) {
  const bool is_one = !EmitsRadiance(settings) && instance.mesh && IsOneLamp(instance, settings.trace.emissive_meshes);
  return is_one ? 1 : static_cast<std::size_t>(instance.shape->Elements());
}

bool IsTraced(RenderMode mode) { return mode == RenderMode::whitted || mode == RenderMode::path || ShowsCosts(mode); }

void AddMaterial(SceneFeatures& features, const Material& m, const RenderSettings& settings) {
  features.mirrors |= (!IsBlack(m.kr) || m.coat > 0) && settings.trace.max_depth > 0;
  features.clear |= !IsBlack(m.kt) && settings.trace.max_depth > 0;
  features.bending |= !IsBlack(m.kt) && m.ir != 1 && settings.trace.max_depth > 0;
  features.absorbing |= !IsBlack(m.absorb);
  const bool is_specular = !IsBlack(m.ks) || !IsBlack(m.kr);
  features.textures |= m.texture || (m.specular_map && is_specular);
}

}  // namespace

std::vector<const Light*> ShiningLights(const World& world, const RenderSettings& settings) {
  return settings.mode == RenderMode::path ? LightsOfPath(world) : LightsOfWhitted(world, settings.trace);
}

SceneFeatures FeaturesOf(const World& world, const RenderSettings& settings) {
  const Scene& scene = world.scene();
  SceneFeatures features;
  features.motion = settings.camera.HasMotion() || world.Moves();
  features.lens = settings.camera.HasLens();
  features.projection = settings.view.value_or(world.scene().camera).kind->name;
  features.wide_filter = settings.filter != FilterKind::box;
  features.two_streams = HasTwoStreams(settings);
  features.shared_light = settings.shares_light && !world.Moves();
  if (!IsTraced(settings.mode)) return features;

  std::size_t lights = 0;
  const bool is_path = settings.mode == RenderMode::path;
  for (const Light* light : ShiningLights(world, settings)) {
    ++lights;
    features.lights = true;
    features.area_lights |= light->IsExtended();
  }
  features.shadow_bias = scene.shadow_bias > 0;
  features.environment = scene.environment && !scene.environment->IsBlack();
  const bool shapes_light = EmitsRadiance(settings) || settings.trace.emissive_solids_light;
  for (const Instance& instance : world.Instances()) {
    if (instance.Emits() && (instance.mesh || (shapes_light && instance.shape->CanBeSampled()))) {
      (instance.mesh ? features.emissive_triangles : features.emissive_shapes) = true;
      lights += LightsOf(instance, settings);
    }
    AddMaterial(features, *instance.material, settings);
    if (instance.has_parts)
      for (const Material* part : world.MaterialsOf(instance)) AddMaterial(features, *part, settings);
  }
  if (is_path && features.environment) ++lights;
  const int most = static_cast<int>(std::min<std::size_t>(lights, std::numeric_limits<int>::max()));
  features.choice_of_lights =
      lights > 1 && (is_path ? LightsChosenByPath(settings.trace, most) > 0 : settings.trace.lights > 0);
  return features;
}

std::vector<std::string> SceneFeatures::Names() const {
  const std::pair<bool, const char*> all[] = {{motion, "motion"},
                                              {lens, "lens"},
                                              {lights, "lights"},
                                              {area_lights, "area lights"},
                                              {emissive_triangles, "emissive triangles"},
                                              {emissive_shapes, "emissive shapes"},
                                              {environment, "environment"},
                                              {choice_of_lights, "choice of lights"},
                                              {mirrors, "mirrors"},
                                              {clear, "transmission"},
                                              {bending, "refraction"},
                                              {absorbing, "absorption"},
                                              {textures, "textures"},
                                              {shadow_bias, "shadow bias"},
                                              {wide_filter, "wide filter"},
                                              {two_streams, "two streams"},
                                              {shared_light, "shared light"}};
  std::vector<std::string> names;
  for (const auto& [is_on, name] : all)
    if (is_on) names.emplace_back(name);
  return names;
}

std::string KernelName(const SceneFeatures& features, const RenderSettings& settings) {
  const bool is_pinhole = features.projection == std::string_view("pinhole");
  return std::string(NameOf(settings.mode)) + ", " + (features.motion ? "moving " : "") +
         (features.lens ? is_pinhole ? "lens" : features.projection + std::string(" lens") : features.projection) +
         ", " + NameOf(settings.filter) + " filter";
}

std::vector<std::string> SourcesOfBias(const SceneFeatures& features, const RenderSettings& settings) {
  std::vector<std::string> sources;
  if (settings.denoise) sources.emplace_back("denoise");
  if (settings.clamp == Clamp::samples) sources.emplace_back("clamp samples");
  if (IsGrid(settings.trace.sampler)) sources.push_back(std::string("sampler ") + NameOf(settings.trace.sampler));
  if (SamplesWhereNeighborsDiffer(settings)) sources.emplace_back("adaptive neighbors");
  if (settings.budget.error && settings.budget.adaptive != Adaptive::off) sources.emplace_back("adaptive tile");
  if (!IsTraced(settings.mode)) return sources;
  const TraceSettings& trace = settings.trace;
  const bool is_path = settings.mode == RenderMode::path;
  const bool may_bounce = is_path || features.mirrors || features.clear;
  if (may_bounce || trace.max_depth == 0) sources.push_back("max_depth " + std::to_string(trace.max_depth));
  if (!is_path && may_bounce && trace.roulette != Roulette::on && trace.min_luminance > 0)
    sources.push_back("min_luminance " + SettingText(trace.min_luminance));
  if (!trace.shadows) sources.emplace_back("shadows off");
  if (features.shadow_bias) sources.emplace_back("shadow_bias");
  return sources;
}

bool CutsLight(const std::string& source) {
  return source.starts_with("max_depth") || source.starts_with("min_luminance");
}

std::vector<std::string> CropDifferences(const RenderSettings& settings) {
  std::vector<std::string> differences;
  if (!settings.crop) return differences;
  if (settings.budget.seconds > 0) differences.emplace_back("time");
  if (settings.budget.error) differences.emplace_back("error");
  if (settings.replay) differences.emplace_back("replay");
  if (IsSubsampled(settings)) differences.emplace_back("samples");
  const bool has_library = settings.denoise && Resolved(settings.denoiser) != Denoiser::regression;
  if (has_library) differences.push_back(std::string("denoiser ") + NameOf(settings.denoiser));
  return differences;
}

}  // namespace ray

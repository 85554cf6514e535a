#include "source/inspect/PixelExplanation.h"

#include <algorithm>
#include <cmath>
#include <functional>


namespace ray {
namespace {

double Distance(const R2::Color& a, const R2::Color& b) {
  const R2::Color d = a - b;
  return std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)});
}

/// A change of the settings, and the behavior of the other tracer that it stands for.
struct Change {
  std::string text;
  std::function<void(TraceSettings&)> apply;
};

std::vector<Change> Changes(const TraceSettings& now) {
  const std::string depth = "-max_depth " + std::to_string(now.max_depth);
  std::vector<Change> changes{
      {"the reference has one bounce more than " + depth, [](TraceSettings& trace) { ++trace.max_depth; }},
      {now.shadows ? "the reference has no shadows" : "the reference has shadows",
       [](TraceSettings& trace) { trace.shadows = !trace.shadows; }},
      {now.fresnel ? "the reference is without -fresnel" : "the reference has -fresnel",
       [](TraceSettings& trace) { trace.fresnel = !trace.fresnel; }},
      {now.internal_reflection ? "the reference has no total internal reflection"
                               : "the reference has total internal reflection",
       [](TraceSettings& trace) { trace.internal_reflection = !trace.internal_reflection; }}};
  if (now.max_depth > 0)
    changes.push_back(
        {"the reference has one bounce fewer than " + depth, [](TraceSettings& trace) { --trace.max_depth; }});
  return changes;
}

std::string NameOf(const RecordedRay& ray, const World& world) {
  std::string name = "the " + std::string(ray_kind_names[static_cast<std::size_t>(ray.kind)]) + " ray";
  if (!ray.towards.empty()) return name + " to " + ray.towards.substr(0, ray.towards.find(' '));
  return name + " to " + (ray.hit ? HitBy(ray, world) : "the background");
}

}  // namespace

std::string HitBy(const RecordedRay& ray, const World& world) {
  if (!ray.hit) return {};
  const Node& node = *world.Instances()[ray.hit->instance].node;
  const auto recipe = node.shape->MadeFrom();
  const std::string kind = recipe ? recipe->kind : node.operation ? "csg" : "mesh";
  return kind + (node.location.line > 0 ? ", line " + std::to_string(node.location.line) : "");
}

std::vector<R2::Color> SubtreeLight(const PixelTrace& pixel) {
  std::vector<R2::Color> light;
  for (const RecordedRay& ray : pixel.rays) light.push_back(ray.contribution);
  for (std::size_t i = pixel.rays.size(); i-- > 0;)
    if (const int parent = pixel.rays[i].parent; parent != RecordedRay::none)
      light[static_cast<std::size_t>(parent)] += light[i];
  return light;
}

std::optional<PixelExplanation> ExplainPixel(const PixelTrace& pixel, const R2::Color& reference,
                                             const LoadedScene& scene, const RenderSettings& settings) {
  constexpr double invisible = 0.5 / 255, most_left = 0.1;
  const R2::Color ours = pixel.Mean();
  const double difference = Distance(ours, reference);
  if (!(difference > invisible) || pixel.samples.empty()) return {};
  double least = most_left * difference;
  std::optional<PixelExplanation> best;
  const auto consider = [&](const R2::Color& color, std::optional<std::size_t> ray, const std::string& text) {
    const double left = Distance(color, reference);
    if (left < least) least = left, best = PixelExplanation{ray, text};
  };
  const std::vector<R2::Color> light = SubtreeLight(pixel);
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (IsBlack(light[i]) || pixel.rays[i].kind == RayKind::camera) continue;
    const R2::Color share = light[i] / static_cast<double>(pixel.samples.size());
    const std::string name = NameOf(pixel.rays[i], scene.world);
    consider(ours - share, i, "the reference lacks what " + name + " brings");
    consider(ours + share, i, "the reference counts twice what " + name + " brings");
  }
  for (const RecordedRay& ray : pixel.rays)  // what would come if nothing were in the way
    if (ray.kind == RayKind::shadow && ray.hit)
      consider(ours + ray.throughput / static_cast<double>(pixel.samples.size()),
               static_cast<std::size_t>(&ray - pixel.rays.data()),
               "the reference has no shadow where " + NameOf(ray, scene.world) + " is blocked");
  for (const Change& change : Changes(settings.trace)) {
    RenderSettings changed = settings;
    change.apply(changed.trace);
    const int samples = static_cast<int>(pixel.samples.size());
    const PixelTrace other =
        PixelTracer(scene.world, *scene.accelerator, changed).Trace(pixel.column, pixel.row, samples);
    consider(other.Mean(), {}, change.text);
  }
  return best;
}

}  // namespace ray

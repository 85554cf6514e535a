#include "grader/RuledShading.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"
#include "grader/Changes.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/TriangleLamp.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray::grade {
namespace {

/// Returns the transform of each instance's group, baked or not.
std::vector<const R3::Transform*> TransformsOf(const World& world) {
  std::vector<const R3::Transform*> transforms(world.Instances().size());
  for (const FlatNode& node : world.Nodes())
    if (node.instance >= 0) transforms[static_cast<std::size_t>(node.instance)] = &world.Frames()[node.frame];
  return transforms;
}

/// Returns the length of a normal that was not normalized: a sphere's points are a radius away from its center, and a
/// matrix stretches what it transforms.
double LengthOfNormal(const Instance& instance, const R3::Transform& transform, const R3::Vector& world_normal) {
  const R3::Vector local = TransposeTimes(transform.Forward(), world_normal);
  const auto sphere = instance.shape->AsSphere();
  return (sphere ? sphere->radius : 1) / Length(local);
}

/// Returns the unit normal on the viewer's side.
R3::Vector FacingViewer(const ShadingPoint& p, const R3::Vector& normal) {
  return Unit(Dot(normal, p.wo) < 0 ? -normal : normal);
}

constexpr std::uint64_t first_key = 1000;  // of the random choices of each light

}  // namespace

RuledShading::RuledShading(const World& world, const Accelerator& accelerator, const TraceSettings& settings,
                           const ShadingRules& rules)
    : Whitted(world, accelerator, settings),
      tracer_(world, accelerator, settings.shadows),
      settings_(settings),
      rules_(rules),
      transforms_(TransformsOf(world)) {
  for (const Light* light : Lights()) fading_.push_back(FadingOf(*light));
}

RuledShading::Fading RuledShading::FadingOf(const Light& light) {
  R3::Recipe recipe = light.MadeFrom();
  LightArguments arguments{recipe.kind, recipe};
  const auto value = [&](const char* name, double otherwise) {
    const double* found = arguments.At(name);
    return found ? *found : otherwise;
  };
  Fading fading{value("ca", 1), value("la", 0), value("qa", 0), {}, value("sc", 0), value("sd", 0)};
  if (arguments.kind == "spot_light") fading.axis = Unit(R3::Vector{value("dx", 0), value("dy", 0), value("dz", -1)});
  return fading;
}

double RuledShading::FadingOf(std::size_t which, const R3::Vector& to_light) const {
  const auto& [constant, linear, quadratic, axis, cutoff, exponent] = fading_[which];
  const auto divisor = [&](double d) { return constant + linear * d + quadratic * d * d; };
  const double d = Length(to_light), fade = divisor(d);
  double factor = 1;
  if (rules_.fading == ShadingRules::Fading::multiplied) factor = fade * fade;
  if (rules_.fading == ShadingRules::Fading::of_square) factor = fade / divisor(d * d);
  if (!rules_.spot_is_linear || !axis) return factor;
  const double cosine = std::min(1.0, -Dot(*axis, Unit(to_light)));
  return factor * std::max(0.0, 1 - R1::Acos(cosine) / cutoff) / R1::Pow(cosine, exponent);
}

void RuledShading::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  std::vector<CameraSample> moved;
  if (rules_.behind_the_eye) {
    // The smallest t, negative or not, is the first hit from behind the whole scene.
    const R3::Box& bounds = world().scene().root.bounds;
    for (CameraSample sample : samples) {
      R3::Ray& ray = sample.ray;
      const double back = Length(bounds.Center() - ray.origin) + bounds.Radius();
      if (std::isfinite(back)) ray.origin = ray.At(-back / Length(ray.direction));
      moved.push_back(sample);
    }
    samples = moved;
  }
  Whitted::Li(samples, radiances, state);
  if (!rules_.camera_background) return;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (!state.hits[i]) radiances[i] = *rules_.camera_background;
}

/// Mirrored rays depend on wo and N alone, and light is computed before this.
void RuledShading::ApplyToMirror(ShadingPoint& p) const {
  using enum ShadingRules::Mirror;
  if (rules_.mirror == exact || !IsBlack(p.material->kt)) return;
  const double cosine = Dot(p.N, p.wo);
  p.wo = rules_.mirror == opposite ? -p.wo : p.wo - 4 * cosine * p.N;
}

bool RuledShading::CanShade(const World& world, const TraceSettings& settings) {
  const Scene& scene = world.scene();
  if (scene.environment && !scene.environment->IsBlack()) return false;
  if (!TriangleLamps(world, settings.emissive_meshes).empty()) return false;
  return !settings.emissive_solids_light || EmissiveShapes(world).empty();
}

void RuledShading::ApplyToNormal(ShadingPoint& p) const {
  using enum ShadingRules::Normal;
  const Instance& instance = world().Instances()[p.hit.instance];
  const R3::Transform& transform = *transforms_[p.hit.instance];
  const R3::Vector local = TransposeTimes(transform.Forward(), p.N);
  const R3::Vector outward = AsVector(p.at.shading_normal);
  switch (rules_.normal) {
    case exact:
      return;
    case by_matrix:
      p.N = FacingViewer(p, transform.Forward() * local);
      return;
    case by_inverse:
      p.N = FacingViewer(p, transform.Inverse() * local);
      return;
    case untransformed:
      p.N = FacingViewer(p, local);
      return;
    case inward:
      p.N = -outward;
      return;
    case not_facing:
      p.N = outward;
      return;
    case flat:
      p.N = p.Outward();
      p.is_smoothed = false;
      return;
    case stretched:
      p.N = (1 / Length(local)) * p.N;
      return;
    case not_normalized:
      p.N = LengthOfNormal(instance, transform, p.N) * p.N;
      return;
  }
}

void RuledShading::Shade(std::span<ShadingPoint> points, std::span<R2::Color> radiances, TraceState& state) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    ShadingPoint& p = points[i];
    radiances[i] = p.EmittedAndAmbient(world());
    ApplyToNormal(p);
    if (rules_.always_leaves_glass) p.relative_index = p.material->ir;
    if (rules_.leaving_is_entering) p.relative_index = 1 / p.material->ir;
  }
  const std::size_t count = Lights().size();
  for (std::size_t i = 0; i < count; ++i) {
    if (rules_.lights == ShadingRules::Lights::first && i > 0) break;
    if (rules_.lights == ShadingRules::Lights::last && i + 1 < count) continue;
    AddLight(i, points, radiances, state);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    ShadingPoint& p = points[i];
    const bool goes_on = p.path.depth < settings_.max_depth;
    if (rules_.mirror_replaces && goes_on) radiances[i] = radiances[i] * (R2::Color{1, 1, 1} - p.material->kr);
    if (rules_.glass_replaces && goes_on) radiances[i] = radiances[i] * (R2::Color{1, 1, 1} - p.material->kt);
    ApplyToMirror(p);
  }
}

void RuledShading::AddLight(std::size_t which, std::span<ShadingPoint> points, std::span<R2::Color> radiances,
                            TraceState& state) const {
  const Light& light = *Lights()[which];
  const auto count = static_cast<std::uint32_t>(light.IsExtended() ? settings_.shadow_samples : 1);
  state.arrived.assign(points.size(), {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    ShadingPoint& p = points[i];
    if (!p.HasReflectance()) continue;
    const ray::Points random = p.path.index.PointsFor(first_key + which, settings_.sampler, settings_.samples, count);
    for (std::uint32_t k = 0; k < count && !state.IsStopped(); ++k)
      AddSample(which, p, i, random.Get2D(p.path.index.FirstOf(count) + k), 1.0 / count, radiances[i], state);
  }
  tracer_.TraceShadowRays(state);
  for (std::size_t i = 0; i < points.size(); ++i) radiances[i] += state.arrived[i];
}

double RuledShading::CosineOf(const ShadingPoint& p, const R3::Vector& L) const {
  const double cosine = Dot(p.N, L);
  switch (rules_.cosine) {
    case ShadingRules::Cosine::clamped:
      return std::max(0.0, cosine);
    case ShadingRules::Cosine::absolute:
      return std::abs(cosine);
    case ShadingRules::Cosine::none:
      return cosine > 0 ? 1 : 0;
    case ShadingRules::Cosine::squared:
      return cosine > 0 ? cosine * cosine : 0;
  }
  return 0;
}

/// Returns true if an absolute cosine lets a light shine from the other side of a surface.
bool RuledShading::IsLitFromBehind(const ShadingPoint& p, const R3::Vector& L) const {
  const bool counts = rules_.cosine == ShadingRules::Cosine::absolute || rules_.highlight_behind;
  return counts && Dot(p.N, L) < 0;
}

R2::Color RuledShading::HighlightOf(const ShadingPoint& p, const R3::Vector& L) const {
  if (!rules_.half_vector && !rules_.highlight_opposite) return Highlight(p, L);
  const double lobe = rules_.half_vector ? Dot(p.N, Unit(L + p.wo)) : -LobeCosine(p, L);
  return p.Mapped(p.material->ks * (lobe > 0 && !IsBlack(p.material->ks) ? R1::Pow(lobe, p.material->n) : 0));
}

R3::Vector RuledShading::ShadowDirection(std::size_t which, const ShadingPoint& p, const LightSample& sample) const {
  if (rules_.shadow != ShadingRules::Shadow::of_next_light) return sample.to_light;
  const Light& next = *Lights()[(which + 1) % Lights().size()];
  const auto other = next.Illuminate(p.free_point, {0.5, 0.5});
  return other ? other->to_light : sample.to_light;
}

void RuledShading::AddSample(std::size_t which, ShadingPoint& p, std::size_t index, const R2::Point& u, double weight,
                             R2::Color& radiance, TraceState& state) const {
  const Light& light = *Lights()[which];
  const auto sample = light.Illuminate(p.free_point, u);
  if (!sample) return;
  const R3::Vector L = Unit(sample->to_light);
  const double cosine = CosineOf(p, L);
  if (!(cosine > 0) && !rules_.highlight_behind) return;
  const R2::Color arriving = weight * FadingOf(which, sample->to_light) * sample->irradiance;
  R2::Color reflected = cosine * p.kd * arriving;
  R2::Color highlight = HighlightOf(p, L) * arriving;
  if (rules_.highlight_by_cosine) highlight = cosine * highlight;
  if (rules_.highlight_in_shadow)
    radiance += highlight;
  else
    reflected += highlight;
  ShadowTarget target = sample->Target();
  target.to_light = ShadowDirection(which, p, *sample);
  if (rules_.shadow == ShadingRules::Shadow::beyond_light) target.is_infinite = true, target.reaching = -1;
  // A thin surface casts no shadow on itself if programs start their shadow rays slightly towards the light.
  const R3::Vector N = p.N;
  if (IsLitFromBehind(p, L)) p.N = -N;
  tracer_.AddShadowRay(
      p, index, target, reflected, p.path.throughput, [&] { return light.Describe(); }, state);
  p.N = N;
}

}  // namespace ray::grade

#include "source/integrate/lights/LightSource.h"

#include <algorithm>
#include <bit>
#include <numbers>

#include "R3/Warp.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/EmissiveTriangle.h"
#include "source/integrate/lights/TriangleLamp.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;

class SceneLight : public LightSource {
 public:
  explicit SceneLight(const Light& light) : light_(light) {}

  std::optional<LightSample> Sample(const ShadingPoint& p, const R2::Point& u) const override {
    return light_.Illuminate(p.free_point, u);
  }
  bool MayShineOn(const ShadingPoint& p) const override { return light_.MayShineOn(p.free_point); }
  const Light* OfScene() const override { return &light_; }
  bool IsExtended() const override { return light_.IsExtended(); }
  bool IsInfinite() const override { return light_.Bound().is_infinite; }
  LightBound Bound() const override { return light_.Bound(); }
  std::string Describe() const override { return light_.Describe(); }

 private:
  const Light& light_;
};

/// Returns the bound of a surface as a light of path tracing: radiance times area, falling off with the squared
/// distance.
LightBound RadiantBound(LightBound bound, double area) {
  bound.power *= area / pi;
  bound.ca = 0;
  bound.qa = 1;
  return bound;
}

/// A triangle whose emission is a radiance.
class RadiantTriangle : public LightSource {
 public:
  explicit RadiantTriangle(const EmissiveTriangle& triangle) : triangle_(triangle) {}

  std::optional<LightSample> Sample(const ShadingPoint& p, const R2::Point& u) const override {
    const R3::Vector towards = triangle_.PointTowards(p.free_point, u, p.time) - p.free_point;
    const double pdf = PdfOf(towards, 1);
    if (!(pdf > 0)) return {};
    return LightSample{triangle_.RadianceAlong(towards) / pdf, towards, false, pdf, 0, triangle_.primitive};
  }
  bool HasPdf() const override { return true; }
  double Pdf(const ShadingPoint&, const ShadingPoint& hit) const override {
    return PdfOf(hit.direction, hit.hit.t);
  }
  std::int64_t Primitive() const override { return triangle_.primitive; }
  std::int64_t Reached() const override { return triangle_.primitive; }
  LightBound Bound() const override { return RadiantBound(triangle_.Bound(), triangle_.area); }
  std::string Describe() const override { return triangle_.Describe(); }

 private:
  double PdfOf(const R3::Vector& towards, double t) const {
    return SolidAnglePdf(triangle_.normal, towards, t, triangle_.area);
  }

  EmissiveTriangle triangle_;
};

/// A shape other than a triangle whose emission is a radiance.
class RadiantShape : public LightSource {
 public:
  explicit RadiantShape(const EmissiveShape& shape) : shape_(shape) {}

  std::optional<LightSample> Sample(const ShadingPoint& p, const R2::Point& u) const override {
    const auto drawn = shape_.SampleTowards(p.free_point, u, p.time);
    if (!drawn) return {};
    return LightSample{drawn->radiance / drawn->pdf, drawn->towards, false, drawn->pdf, 0, Reached()};
  }
  bool SampleEach(LightSamples& samples, LightSamples::Each& pdfs) const override {
    if (!shape_.CanSampleEach()) return false;
    shape_.SampleEach(samples, pdfs);
    return true;
  }
  bool HasPdf() const override { return true; }
  double Pdf(const ShadingPoint& from, const ShadingPoint& hit) const override {
    return shape_.Pdf(from.free_point, hit.hit.t * hit.direction, hit.at.normal, hit.time);
  }
  std::int64_t Primitive() const override { return shape_.Primitive(); }
  std::int64_t Reached() const override { return shape_.Reached(); }
  LightBound Bound() const override { return RadiantBound(shape_.Bound(), shape_.ProjectedAreaOfBounds()); }
  std::string Describe() const override { return shape_.Describe(); }

 private:
  EmissiveShape shape_;
};

// Lamps are shapes whose emission is a color, as in mode whitted and with -emission color: each of their points shines
// like a point light without attenuation. The samples have no pdf, since light from a lamp is then not an integral over
// directions, which scattered rays could also sample.

class LampOfTriangles : public LightSource {
 public:
  LampOfTriangles(const World& world, TriangleLamp lamp) : world_(world), lamp_(std::move(lamp)) {}

  std::optional<LightSample> Sample(const ShadingPoint& p, const R2::Point& u) const override {
    if (lamp_.Holds(world_.PrimitiveId(p.hit))) return {};
    return lamp_.SampleTowards(p.free_point, u, p.time);
  }
  LightBound Bound() const override { return lamp_.Bound(); }
  std::string Describe() const override { return lamp_.Describe(); }

 private:
  const World& world_;
  TriangleLamp lamp_;
};

class LampOfShape : public LightSource {
 public:
  LampOfShape(const World& world, const EmissiveShape& shape) : world_(world), shape_(shape) {}

  std::optional<LightSample> Sample(const ShadingPoint& p, const R2::Point& u) const override {
    if (shape_.Primitive() == world_.PrimitiveId(p.hit)) return {};
    auto drawn = shape_.SampleTowards(p.free_point, u, p.time);
    if (!drawn && !shape_.DrawsInSight()) drawn = SampleAgain(p, u);
    if (!drawn) return {};
    return LightSample{.irradiance = drawn->radiance, .to_light = drawn->towards, .reaching = shape_.Reached()};
  }
  LightBound Bound() const override { return shape_.Bound(); }
  std::string Describe() const override { return shape_.Describe(); }

 private:
  /// Some shapes also sample places that they hide themselves. The result is a mean over the others.
  std::optional<EmissiveShape::Sample> SampleAgain(const ShadingPoint& p, const R2::Point& u) const {
    constexpr std::uint64_t again_key = camera_key - 3;  // below surfaces, next to lights: there are not that many
    constexpr std::uint32_t most_attempts = 64;
    const RandomKey key = p.path.index.key.Child(again_key).Child(std::bit_cast<std::uint64_t>(u.x));
    const Points again(SamplerKind::random, key.Child(std::bit_cast<std::uint64_t>(u.y)), most_attempts);
    std::optional<EmissiveShape::Sample> drawn;
    for (std::uint32_t k = 0; k < most_attempts && !drawn; ++k)
      drawn = shape_.SampleTowards(p.free_point, again.Get2D(k), p.time);
    return drawn;
  }

  const World& world_;
  EmissiveShape shape_;
};

/// The environment, with directions by importance sampling, or uniformly.
class EnvironmentLight : public LightSource {
 public:
  EnvironmentLight(const Environment& environment, bool is_uniform)
      : environment_(environment), is_uniform_(is_uniform) {}

  std::optional<LightSample> Sample(const ShadingPoint&, const R2::Point& u) const override {
    if (is_uniform_) {
      const R3::Vector direction = R3::SampleUniformSphere(u);
      const R2::Color irradiance = environment_.Radiance(direction) / R3::uniform_sphere_pdf;
      return LightSample{irradiance, direction, true, R3::uniform_sphere_pdf};
    }
    const Environment::Sample drawn = environment_.Draw(u);
    return LightSample{drawn.radiance / drawn.pdf, drawn.direction, true, drawn.pdf};
  }
  bool SampleEach(LightSamples& samples, LightSamples::Each& pdfs) const override {
    if (is_uniform_) return false;
    environment_.DrawEach(samples, pdfs);
    return true;
  }
  bool HasPdf() const override { return true; }
  bool IsInfinite() const override { return true; }
  LightBound Bound() const override {
    const Environment::Sample any = environment_.Draw({0.5, 0.5});  // luminance over pdf is the same for all directions
    return {.power = Luminance(any.radiance) / any.pdf / pi, .is_infinite = true};
  }
  std::string Describe() const override { return "environment"; }

 private:
  const Environment& environment_;
  bool is_uniform_;
};

void AddLamps(const World& world, const TraceSettings& settings, LightSources& lights) {
  for (TriangleLamp& lamp : TriangleLamps(world, settings.emissive_meshes))
    lights.push_back(std::make_unique<LampOfTriangles>(world, std::move(lamp)));
  if (!settings.emissive_solids_light) return;
  for (const EmissiveShape& shape : EmissiveShapes(world))
    lights.push_back(std::make_unique<LampOfShape>(world, shape));
}

bool HasEmitters(const World& world) { return std::ranges::any_of(world.Instances(), &Instance::Emits); }

/// Returns the scene's lights that are not black. The default ones are omitted if something else shines.
std::vector<const Light*> LightsBeside(const World& world, bool something_else_shines) {
  const Scene& scene = world.scene();
  return scene.has_default_lights && something_else_shines ? std::vector<const Light*>() : LightsOf(scene);
}

}  // namespace

std::vector<const Light*> LightsOfPath(const World& world) {
  const auto& environment = world.scene().environment;
  return LightsBeside(world, HasEmitters(world) || (environment && !environment->IsBlack()));
}

std::vector<const Light*> LightsOfWhitted(const World& world, const TraceSettings& settings) {
  return LightsBeside(world, settings.emissive_solids_light && HasEmitters(world));
}

LightSources LightSourcesOfPath(const World& world, const TraceSettings& settings) {
  LightSources lights;
  for (const Light* light : LightsOfPath(world)) lights.push_back(std::make_unique<SceneLight>(*light));
  if (settings.emission == Emission::color) {
    AddLamps(world, settings, lights);
  } else {
    for (const EmissiveTriangle& t : EmissiveTriangles(world)) lights.push_back(std::make_unique<RadiantTriangle>(t));
    for (const EmissiveShape& shape : EmissiveShapes(world)) lights.push_back(std::make_unique<RadiantShape>(shape));
  }
  const auto& environment = world.scene().environment;
  if (environment && !environment->IsBlack())
    lights.push_back(std::make_unique<EnvironmentLight>(*environment, settings.strategy == LightStrategy::uniform));
  return lights;
}

LightSources LightSourcesOfWhitted(const World& world, const TraceSettings& settings) {
  LightSources lights;
  for (const Light* light : LightsOfWhitted(world, settings)) lights.push_back(std::make_unique<SceneLight>(*light));
  AddLamps(world, settings, lights);
  return lights;
}

}  // namespace ray

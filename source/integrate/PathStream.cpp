#include "source/integrate/PathStream.h"

#include <algorithm>
#include <cmath>

#include "R1/BatchSize.h"
#include "R3/Numeric.h"
#include "source/integrate/ShadingPoints.h"

namespace ray {
namespace {

constexpr std::size_t most_paths = R1::batch_size;
using Each = LightSamples::Each;

R3_VECTORIZED
void TurnAboutNormals(const VectorOfEach& normals, const PointsOfEach<4>& random, std::size_t count,
                      VectorOfEach& directions) {
  for (std::size_t i = 0; i < count; ++i)
    directions.Set(i, DiffuseDirection(normals[i], {random.coordinates[0][i], random.coordinates[1][i]}));
}

/// By channel, since choosing between whole colors is a branch.
R2::Color Chosen(bool first, const R2::Color& a, const R2::Color& b) {
  return {first ? a.r : b.r, first ? a.g : b.g, first ? a.b : b.b};
}

/// Makes cosines of N and unit L of each sample that brings light. Returns whether the squares of their lengths are in
/// range; else there is nothing to rely on.
R3_VECTORIZED
bool MakeCosines(const VectorOfEach& normals, const LightSamples& samples, Each& cosines) {
  std::uint64_t are_safe = 1;
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const double square = Dot(samples.ToLight(i), samples.ToLight(i));
    const bool is_black = samples.r[i] + samples.g[i] + samples.b[i] == 0;
    are_safe &= R3::IsSafeSquare(square) | is_black;
    cosines[i] = Dot(normals[i], samples.ToLight(i) / std::sqrt(square));
  }
  return are_safe != 0;
}

}  // namespace

struct PathStream::Front {
  std::vector<ShadingPoint> points;
  std::vector<std::uint32_t> paths;
  // Made of all points, once they are known.
  std::vector<SampleIndex> indices;
  VectorOfEach normals;
  ColorOfEach kd, throughputs;
  alignas(64) Each are_diffuse;       // 1 where the surface is diffuse alone, else 0
  std::vector<std::uint32_t> others;  // those that are not
  std::vector<Bsdf> bsdfs;            // of others
  // For lights of the scene language.
  bool has_highlights;
  VectorOfEach wo;
  ColorOfEach ks;
  std::array<std::uint64_t, most_paths> exponents;  // 0 where they are not whole
  std::uint64_t exponent_bits;                      // those that any of them has
  std::vector<std::uint32_t> others_by_phong;       // with a coat or an exponent that is not whole

  /// What is known of a point at first.
  void Add(const PathState& arriving, const WorldHit& hit, std::uint32_t path) {
    points.emplace_back(arriving, hit);
    paths.push_back(path);
  }
  void Complete(const TraceSettings& settings) {
    indices.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const ShadingPoint& p = points[i];
      indices.push_back(p.path.index);
      normals.Set(i, p.N);
      kd.Set(i, p.kd);
      throughputs.Set(i, p.path.throughput);
      are_diffuse[i] = IsDiffuse(*p.material) ? 1 : 0;
      if (are_diffuse[i] != 0) continue;
      others.push_back(i);
      bsdfs.emplace_back(p, settings);
    }
  }
  void CompleteHighlights() {
    has_highlights = false, exponent_bits = 0;
    others_by_phong.clear();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Material& m = *points[i].material;
      const bool is_plain = m.coat == 0 && (IsBlack(m.ks) || R1::IsWholeExponent(m.n));
      has_highlights |= !IsBlack(m.ks);
      wo.Set(i, points[i].wo);
      ks.Set(i, m.ks);
      exponents[i] = is_plain && !IsBlack(m.ks) ? static_cast<std::uint64_t>(m.n) : 0;
      exponent_bits |= exponents[i];
      if (!is_plain) others_by_phong.push_back(i);
    }
  }
  void Clear() { points.clear(), paths.clear(), indices.clear(), others.clear(), bsdfs.clear(); }
};

struct PathStream::Loops {
  /// What surfaces that are diffuse alone reflect of light samples with pdfs; false, with the samples as they were,
  /// where lengths leave the range of doubles.
  ///   most_weight   of BSDF sampling
  R3_VECTORIZED
  static bool Reflect(const Front& front, double most_weight, const Each& pdfs, LightSamples& samples) {
    alignas(64) Each cosines;
    if (!MakeCosines(front.normals, samples, cosines)) return false;
    ColorOfEach colors;  // of its own, so that it is clear that nothing overlaps
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const double cosine_pdf = R3::CosineHemispherePdf(cosines[i]);
      const double weight = 1 - std::min(most_weight, MisWeight(cosine_pdf, pdfs[i]));
      const R2::Color color = samples.Color(i), eval = cosine_pdf * front.kd[i];
      const double cosine_if_sampled = pdfs[i] > 0 ? cosines[i] : 0;
      const R2::Color reflected = Chosen(cosine_if_sampled > 0, weight * eval * color, {});
      colors.Set(i, Chosen(front.are_diffuse[i] > 0, reflected, color));
    }
    for (std::uint32_t i = 0; i < samples.count; ++i) samples.SetColor(i, colors[i]);
    return true;
  }

  /// R1::CosinePower of each sample.
  R3_VECTORIZED
  static void RaiseLobes(const Front& front, const LightSamples& samples, Each& powers) {
    alignas(64) Each lobe;
    alignas(64) std::array<std::uint64_t, most_paths> exponents;
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const R3::Vector to_light = samples.ToLight(i), L = to_light / std::sqrt(Dot(to_light, to_light));
      lobe[i] = LobeCosine(front.wo[i], front.normals[i], L);
      powers[i] = lobe[i] > 0 ? 1 : 0;
      exponents[i] = front.exponents[i];
    }
    for (std::uint64_t bits = front.exponent_bits; bits != 0; bits >>= 1) {
      for (std::uint32_t i = 0; i < samples.count; ++i) {
        powers[i] *= exponents[i] & 1 ? lobe[i] : 1;
        lobe[i] *= lobe[i];
        exponents[i] >>= 1;
      }
    }
  }
  /// PhongReflection of each sample, but of others_by_phong, which stay as they were; false as Reflect.
  R3_VECTORIZED
  static bool ReflectByPhong(const Front& front, LightSamples& samples) {
    alignas(64) Each cosines, powers{};
    if (!MakeCosines(front.normals, samples, cosines)) return false;
    if (front.has_highlights) RaiseLobes(front, samples, powers);
    ColorOfEach colors;
    for (std::uint32_t i = 0; i < samples.count; ++i) {
      const R2::Color kd = front.kd[i], ks = front.ks[i], both = kd + ks;
      const double cosine_if_reflected = both.r + both.g + both.b > 0 ? cosines[i] : 0;
      const R2::Color reflected = (cosines[i] * kd + ks * powers[i]) * samples.Color(i);
      colors.Set(i, Chosen(cosine_if_reflected > 0, reflected, {}));
    }
    for (const std::uint32_t i : front.others_by_phong) colors.Set(i, samples.Color(i));
    for (std::uint32_t i = 0; i < samples.count; ++i) samples.SetColor(i, colors[i]);
    return true;
  }

  struct Scattered {
    ColorOfEach throughputs;  // what survives, 0 where nothing does
    alignas(64) Each pdfs;
  };
  /// Of surfaces that are diffuse alone into each direction. No path survives less likely than `least_survival`.
  R3_VECTORIZED
  static Scattered Scatter(const Front& front, double least_survival, const std::array<double, most_paths>& choices,
                           const VectorOfEach& directions) {
    Scattered scattered;
    const std::size_t count = front.points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const R2::Color kd = front.kd[i];
      const double pdf = R3::CosineHemispherePdf(Dot(front.normals[i], directions[i]));
      const R2::Color throughput = front.throughputs[i] * (pdf * kd) / pdf;
      const double survival = std::max(least_survival, SurvivalProbability(throughput));
      // Nested, since g++ makes no vector instructions of several conditions in one.
      const double if_above = pdf > 0 ? survival : 0, if_reflected = Luminance(kd) > 0 ? if_above : 0;
      const bool goes_on = choices[i] < (front.are_diffuse[i] > 0 ? if_reflected : 0);
      scattered.pdfs[i] = pdf;
      scattered.throughputs.Set(i, Chosen(goes_on, throughput / survival, {}));
    }
    return scattered;
  }
};

struct PathStream::StepFrom {
  Step step;
  std::uint32_t from;
};

void PathStream::Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const {
  if (state.recorder) return Path::Li(samples, radiances, state);
  for (std::size_t i = 0; i < samples.size(); i += most_paths) {
    const std::size_t count = std::min(samples.size() - i, most_paths);
    TraceTogether(samples.subspan(i, count), radiances.subspan(i, count), state);
  }
}

void PathStream::TraceTogether(std::span<const CameraSample> samples, std::span<R2::Color> radiances,
                               TraceState& state) const {
  Front fronts[2];
  Front* front = &fronts[0];
  front->points = tracer_.CameraHits(samples, state);
  fronts[1].points.reserve(samples.size());
  std::array<R2::Color, most_paths> gathered{};  // beyond the first surface
  for (std::uint32_t i = 0, point = 0; i < samples.size(); ++i) {
    if (!state.hits[i]) {
      radiances[i] = Background(world_.scene(), samples[i].ray.direction);
      continue;
    }
    const ShadingPoint& p = front->points[point++];
    radiances[i] = EmittedAndAmbient(p, state);
    front->paths.push_back(i);
  }
  const std::vector<std::uint32_t> paths = front->paths;
  for (bool is_first = true; !front->points.empty(); is_first = false) {
    front->Complete(settings_);
    if (HasSceneLights()) front->CompleteHighlights();
    LightPoints(*front, state);
    for (std::size_t i = 0; i < front->points.size(); ++i)
      (is_first ? radiances[front->paths[i]] : gathered[front->paths[i]]) += state.arrived[i];
    Front* const next = front == &fronts[0] ? &fronts[1] : &fronts[0];
    next->Clear();
    TakeStep(*front, gathered, *next, state);
    front = next;
  }
  for (const std::uint32_t path : paths) radiances[path] += gathered[path];
}

void PathStream::LightPoints(const Front& front, TraceState& state) const {
  const std::span<const ShadingPoint> points = front.points;
  state.arrived.assign(points.size(), {});
  if (!SamplesAllLights()) {
    auto bsdf = front.bsdfs.begin();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (front.are_diffuse[i] != 0)
        SampleChosenLights(points[i], Bsdf(points[i], settings_), i, state);
      else
        SampleChosenLights(points[i], *bsdf++, i, state);
    return tracer_.TraceShadowRays(state);
  }
  for (int light = 0; light < lights_.Count() && !state.IsStopped(); ++light) AddLight(light, front, state);
  tracer_.TraceShadowRays(state);
}

void PathStream::AddLight(int light, const Front& front, TraceState& state) const {
  PointsOfEach<2> random;
  if (lights_.IsExtended(light))
    GetOfEach(front.indices, KeyOf(light), settings_.sampler, settings_.samples, random);
  else
    random = {};
  LightSamples samples;
  samples.count = static_cast<std::uint32_t>(front.points.size());
  if (lights_.IsLamp(light)) return AddLamp(light, front, random, state);
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    samples.SetFrom(i, front.points[i].free_point);
    samples.u[i] = random.coordinates[0][i], samples.v[i] = random.coordinates[1][i];
  }
  if (lights_.SceneLight(light)) {
    lights_.SceneLight(light)->IlluminateEach(samples);
    ReflectEachByPhong(front, samples);
  } else {
    alignas(64) Each pdfs;
    lights_.SampleEach(front.points, light, samples, pdfs);
    ReflectEach(front, pdfs, samples);
  }
  const bool is_infinite = lights_.IsInfinite(light);
  const std::int64_t reached = lights_.Reached(light);
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const R2::Color reflected = samples.Color(i);
    if (IsBlack(reflected)) continue;
    constexpr R2::Color no_more{1, 1, 1};
    tracer_.AddShadowRay(
        front.points[i], i, {.to_light = samples.ToLight(i), .is_infinite = is_infinite, .reaching = reached},
        front.throughputs[i] * reflected, no_more, [&] { return lights_.Describe(light); }, state);
  }
}

void PathStream::AddLamp(int lamp, const Front& front, const PointsOfEach<2>& random, TraceState& state) const {
  const auto& u = random.coordinates;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const ShadingPoint& p = front.points[i];
    if (!ReflectsLights(p, settings_)) continue;
    if (const auto sample = lights_.Sample(p, lamp, {u[0][i], u[1][i]}))
      AddLightSample(p, Reflected(p, Bsdf(p, settings_), *sample), *sample, i, state);
  }
}

void PathStream::ReflectEach(const Front& front, const LightSamples::Each& pdfs, LightSamples& samples) const {
  if (!sampled_.lights) {
    for (std::uint32_t i = 0; i < samples.count; ++i) samples.SetColor(i, {});
    return;
  }
  const auto reflect = [&](std::uint32_t i, const Bsdf& bsdf) {
    const LightSample sample{samples.Color(i), samples.ToLight(i), false, pdfs[i]};
    if (!IsBlack(sample.irradiance)) samples.SetColor(i, Reflected(front.points[i], bsdf, sample));
  };
  if (!Loops::Reflect(front, sampled_.bsdf ? 1 : 0, pdfs, samples)) [[unlikely]] {
    for (std::uint32_t i = 0; i < samples.count; ++i) reflect(i, Bsdf(front.points[i], settings_));
    return;
  }
  for (std::size_t k = 0; k < front.others.size(); ++k) reflect(front.others[k], front.bsdfs[k]);
}

void PathStream::ReflectEachByPhong(const Front& front, LightSamples& samples) const {
  const auto reflect = [&](std::uint32_t i) {
    const ShadingPoint& p = front.points[i];
    const bool is_lit = p.HasReflectance() && !IsBlack(samples.Color(i));
    samples.SetColor(i, is_lit ? PhongReflection(p, Unit(samples.ToLight(i)), samples.Color(i)) : R2::Color{});
  };
  if (Loops::ReflectByPhong(front, samples)) [[likely]]
    for (const std::uint32_t i : front.others_by_phong) reflect(i);
  else
    for (std::uint32_t i = 0; i < samples.count; ++i) reflect(i);
}

void PathStream::TakeStep(const Front& front, std::span<R2::Color> gathered, Front& next, TraceState& state) const {
  const std::span<const ShadingPoint> points = front.points;
  if (IsLast(points[0]))  // all have gone as far
    for (const ShadingPoint& p : points) CountCutThroughput(p, state);
  if (!MayContinue(points[0])) return;
  StepsByLobe steps_by_lobe = SampleBsdfs(front);
  std::array<const StepFrom*, most_paths> arriving, escaping;
  std::size_t escaped = 0;
  for (Steps& steps : steps_by_lobe) {
    TraceSteps(steps, state);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      tracer_.Arrive(steps[k].step.path, state.hits[k], state);
      if (state.hits[k]) {
        arriving[next.points.size()] = &steps[k];
        next.Add(steps[k].step.path, *state.hits[k], front.paths[steps[k].from]);
      } else {
        escaping[escaped++] = &steps[k];
      }
    }
  }
  AddBackgrounds(front, {escaping.data(), escaped}, gathered, state);
  CompleteShadingPoints(world_, next.points);
  for (std::size_t i = 0; i < next.points.size(); ++i) {
    const auto& [step, from] = *arriving[i];
    tracer_.SetSides(next.points[i], state);
    AddEmitted(points[from], step, next.points[i], gathered[next.paths[i]], state);
  }
  if (IsLast(points[0])) next.Clear();
}

void PathStream::AddBackgrounds(const Front& front, std::span<const StepFrom* const> steps,
                                std::span<R2::Color> gathered, TraceState& state) const {
  const Environment* environment = lights_.environment();
  if (!environment) {
    for (const auto* s : steps) gathered[front.paths[s->from]] += BackgroundSeen(front.points[s->from], s->step, state);
    return;
  }
  LightSamples seen;
  alignas(64) Each pdfs;
  seen.count = static_cast<std::uint32_t>(steps.size());
  for (std::uint32_t i = 0; i < seen.count; ++i) seen.Set(i, steps[i]->step.path.ray.direction, {});
  environment->SeeEach(seen, pdfs);
  for (std::uint32_t i = 0; i < seen.count; ++i) {
    const auto& [step, from] = *steps[i];
    gathered[front.paths[from]] += EnvironmentSeen({seen.Color(i), pdfs[i]}, front.points[from], step, state);
  }
}

PathStream::StepsByLobe PathStream::SampleBsdfs(const Front& front) const {
  PointsOfEach<4> random;
  GetOfEachAlone(front.indices, scatter_key, settings_.sampler, settings_.samples, random);
  VectorOfEach directions;
  TurnAboutNormals(front.normals, random, front.points.size(), directions);
  const std::int64_t depth = front.points[0].path.depth;  // all have gone as far
  const Loops::Scattered scattered = Loops::Scatter(front, LeastSurvival(depth), random.coordinates[3], directions);
  StepsByLobe steps;
  for (Steps& of_lobe : steps) of_lobe.reserve(front.others.size());
  Steps& diffuse = steps[static_cast<std::size_t>(Lobe::diffuse)];
  diffuse.reserve(front.points.size());
  for (std::uint32_t i = 0; i < front.points.size(); ++i) {
    const ShadingPoint& p = front.points[i];
    const R2::Color throughput = scattered.throughputs[i];
    if (IsBlack(throughput) || p.IsBehindSurface(directions[i])) continue;
    diffuse.push_back({ExtendPath(p, directions[i], Lobe::diffuse, scattered.pdfs[i], throughput), i});
    if (!MayFindLight(p, diffuse.back().step)) diffuse.pop_back();
  }
  const auto& u = random.coordinates;
  for (std::size_t k = 0; k < front.others.size(); ++k) {
    const std::uint32_t i = front.others[k];
    const Choices choices{u[0][i], u[1][i], u[2][i], u[3][i]};
    if (const auto step = SampleBsdf(front.points[i], front.bsdfs[k], choices, directions[i]))
      steps[static_cast<std::size_t>(step->lobe)].push_back({*step, i});
  }
  return steps;
}

void PathStream::TraceSteps(const Steps& steps, TraceState& state) const {
  state.hits.resize(steps.size());
  if (steps.empty()) return;
  state.batch.clear();
  for (const StepFrom& s : steps) state.batch.push_back(s.step.path.ray);
  tracer_.IntersectEach(steps[0].step.path.kind, state.batch, state.hits.data(), state);
}

extern const IntegratorKind path_kind{"path tracing: light over many bounces",
                                      [](const World& world, const Accelerator& accelerator,
                                         const TraceSettings& settings) -> std::unique_ptr<const Integrator> {
                                        return std::make_unique<PathStream>(world, accelerator, settings);
                                      }};

}  // namespace ray

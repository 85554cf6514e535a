#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "source/integrate/Integrator.h"
#include "source/integrate/MisWeight.h"
#include "source/integrate/PathFront.h"
#include "source/integrate/Tracer.h"
#include "source/integrate/lights/Caustics.h"
#include "source/integrate/lights/LightSampler.h"
#include "source/sample/PointsOfEach.h"

namespace ray {

/// Path tracing with next-event estimation: light arrives over every number of bounces up to max_depth, each bounce
/// going one way, chosen by the Bsdf. Units are the course's: kd and kr are the shares that are scattered, so an
/// emission or an environment L is a radiance and is scattered as
///
///     kd / pi * cosine + kr (n + 1) / (2 pi) (V.R)^n      (the second term only where IsGlossy)
///
/// while lights of the scene language scatter by Phong's formula as they do in Whitted. Every shape that emits is a
/// light, on both sides of its surface. With Emission::color what emits is a light as in Whitted, too; then paths add
/// to the light of Whitted what surfaces reflect of each other.
///
/// Many paths are traced together: all of them take a step before any takes the next, so that each stage of a step is a
/// loop over arrays: random points, places on lights, what surfaces reflect, directions. No number of a path depends on
/// which others are traced with it.
///   source   Kajiya, The rendering equation (1986), eq. 6; Cook, Porter, Carpenter, Distributed ray tracing (1984);
///            light and BSDF sampling combined by multiple importance sampling, see MisWeight; Russian roulette after
///            Arvo and Kirk (1990); stages after Laine, Karras, Aila, Megakernels considered harmful: wavefront path
///            tracing on GPUs (2013)
class Path : public Integrator {
 public:
  Path(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 private:
  /// How a ray that continues from a point was chosen.
  struct Step {
    const ShadingPoint& from;
    Lobe lobe;
    double pdf;  // of its direction, as of a BsdfSample
  };
  static Step StepFrom(const PathFront& front, const PathFront::Scattered& scattered, std::uint32_t point) {
    return {front.points[point], scattered.lobe[point], scattered.pdfs[point]};
  }
  /// A ray from a point of a front that hits nothing.
  struct Escaping {
    std::uint32_t from;  // the number of the point
    R3::Vector direction;
    R2::Color throughput;
    int record;  // as of a PathState
  };
  /// By what light that rays can hit is found.
  struct Sampled {
    bool lights, bsdf;

    /// MIS weight of a direction from BSDF sampling; light sampling has the rest.
    double WeightOfBsdf(double bsdf_pdf, double light_pdf) const {
      if (!bsdf) return 0;
      return lights ? MisWeight(bsdf_pdf, light_pdf) : 1;
    }
  };
  // What the keys beneath a surface are for. Lights follow, one each.
  enum Key : std::uint64_t { bounce_key, scatter_key, next_event_key };
  static std::uint64_t KeyOf(int light) { return next_event_key + static_cast<std::uint64_t>(light); }

  /// Li of at most R1::batch_size samples.
  void TraceTogether(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const;
  /// The surfaces that camera rays hit; radiances become what these give of themselves, or what is behind all.
  void SeeFirstSurfaces(std::span<const CameraSample> samples, std::span<R2::Color> radiances, PathFront& front,
                        TraceState& state) const;

  // Light that reaches the points of a front straight from lights, throughput included, goes to state.arrived.
  void SampleLights(PathFront& front, TraceState& state) const;
  void SampleLight(int light, const PathFront& front, TraceState& state) const;
  /// A lamp whose emission is a color, point by point.
  void SampleLamp(int lamp, const PathFront& front, const PointsOfEach<2>& random, TraceState& state) const;
  /// Makes of light samples with pdfs what is reflected of them.
  void Reflect(const PathFront& front, const LightSamples::Each& pdfs, LightSamples& samples) const;
  /// Makes of samples of a light of the scene language what is reflected of them.
  void ReflectByPhong(const PathFront& front, LightSamples& samples) const;
  /// For each point some lights, chosen by importance sampling.
  void SampleChosenLights(const PathFront& front, TraceState& state) const;
  void SampleChosenLights(const ShadingPoint& p, const Bsdf& bsdf, std::size_t index, TraceState& state) const;
  bool SamplesAllLights() const { return lights_at_once_ == 0; }
  /// What p reflects of a sample on a light, if nothing is in between.
  R2::Color Reflected(const ShadingPoint& p, const Bsdf& bsdf, const LightSample& light) const;
  /// Adds the sample as a shadow ray; `index` is where it arrives.
  void AddLightSample(const ShadingPoint& p, const R2::Color& reflected, const LightSample& light, std::size_t index,
                      TraceState& state) const;

  // The way on.
  /// Goes on to the next surfaces, which come to `next`; light that is found on the way is gathered by path.
  void TakeStep(const PathFront& front, std::span<R2::Color> gathered, PathFront& next, TraceState& state) const;
  PathFront::Scattered SampleBsdfs(const PathFront& front) const;
  /// Chooses how a path continues from point number `i`, whose Bsdf this is, if it does not end there.
  ///   choices   uniform in [0, 1): two for a direction, one for a lobe, one for Russian roulette; the direction that
  ///             the diffuse lobe makes of the first two stands in `scattered`
  void SampleBsdf(const ShadingPoint& p, std::uint32_t i, const Bsdf& bsdf, const std::array<double, 4>& choices,
                  PathFront::Scattered& scattered) const;
  /// Follows the rays of one lobe, of state.batch from number `first` on: what they hit comes to `next`, and those that
  /// hit nothing to `escaping`. Returns how many there are.
  std::uint32_t Follow(const PathFront& front, const PathFront::Scattered& scattered, Lobe lobe, std::uint32_t first,
                       PathFront& next, std::vector<Escaping>& escaping, TraceState& state) const;
  /// Traces rays from these points, which go to state.batch from number `first` on; what each hits, to state.hits.
  ///   returns   the numbers of the points whose rays these are: the others' would find nothing
  std::vector<std::uint32_t> TraceFrom(const PathFront& front, const PathFront::Scattered& scattered, Lobe lobe,
                                       std::uint32_t first, TraceState& state) const;
  /// Adds what rays that hit nothing see.
  void AddBackgrounds(const PathFront& front, const PathFront::Scattered& scattered, std::span<const Escaping> escaping,
                      std::span<R2::Color> gathered, TraceState& state) const;
  R2::Color EnvironmentSeen(const Environment::Seen& seen, const Step& step, const R2::Color& throughput,
                            TraceState& state) const;
  /// Adds what the rays that led to the points of `next` see of the surfaces there.
  void AddEmitted(const PathFront& front, const PathFront::Scattered& scattered, const PathFront& next,
                  std::span<R2::Color> gathered, TraceState& state) const;
  /// Emission of what a scattered ray hit, throughput included, weighted against SampleLights.
  R2::Color Emitted(const Step& step, const ShadingPoint& hit) const;

  // Where paths end.
  bool IsLast(const ShadingPoint& p) const { return p.path.depth >= settings_.max_depth; }
  /// Whether light may be found by going on from points of this depth.
  bool MayContinue(const ShadingPoint& p) const { return !IsLast(p) || lights_.CanBeHit(); }
  /// Whether a ray may find light; the last one of a path ends where none is seen.
  bool MayFindLight(const ShadingPoint& from, const R3::Ray& ray) const {
    return !IsLast(from) || lights_.MayBeHitBy(ray);
  }
  /// With what probability a path survives Russian roulette at least from points of a depth: 1 where none is played.
  double LeastSurvival(std::int64_t depth) const;
  /// Counts what is cut off at a point of the last depth.
  void CountCutThroughput(const ShadingPoint& p, TraceState& state) const;
  /// Counts the path where what its step found makes it a caustic.
  void CountCaustic(const Step& step, const R2::Color& emission, TraceState& state) const {
    if (IsSpecular(step.lobe) && step.from.path.is_scattered) state.rays.caustics += caustics_.Counts(emission);
  }

  const World& world_;
  Tracer tracer_;
  TraceSettings settings_;
  LightSampler lights_;
  Caustics caustics_;
  MaterialTraitsOf traits_;
  Sampled sampled_;
  bool has_roulette_, has_ambient_;
  int lights_at_once_;  // 0: all
};

}  // namespace ray

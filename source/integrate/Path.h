#pragma once

#include <array>
#include <span>
#include <vector>

#include "source/integrate/Integrator.h"
#include "source/integrate/MisWeight.h"
#include "source/integrate/PathFront.h"
#include "source/integrate/Tracer.h"
#include "source/integrate/lights/Caustics.h"
#include "source/integrate/lights/LightSampler.h"
#include "source/sample/PointBatch.h"

namespace ray {

/// Path tracing with next-event estimation: light arrives over up to max_depth bounces, each in one direction sampled
/// from the Bsdf. Units are the course's: kd and kr are the fractions of light that are scattered, so an emission or an
/// environment L is a radiance, and is scattered as
///
///     kd / pi * cosine + kr (n + 1) / (2 pi) (V.R)^n      (the second term only if IsGlossy)
///
/// while light from the scene language's lights is reflected by Phong's formula, as in Whitted. Every emissive shape is
/// a light, on both sides of its surface. With Emission::color such shapes are lights as in Whitted; paths then add
/// indirect light to Whitted's image.
///
/// Many paths are traced together: each takes a step before any takes the next, so that every stage of a step is a loop
/// over arrays: random points, light samples, reflected light, directions. A path does not depend on those traced with
/// it.
///   source   Kajiya, The rendering equation (1986), eq. 6; Cook, Porter, Carpenter, Distributed ray tracing (1984);
///            light and BSDF sampling combined by multiple importance sampling, see MisWeight; Russian roulette after
///            Arvo and Kirk (1990); stages after Laine, Karras, Aila, Megakernels considered harmful: wavefront path
///            tracing on GPUs (2013)
class Path : public Integrator {
 public:
  Path(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;
  void AddShared(std::span<R2::Color> radiances, TraceState& state) const override;

 private:
  /// The choice of a ray that continues from a point.
  struct Step {
    const ShadingPoint& from;
    Lobe lobe;
    double pdf;  // of its direction, as in BsdfSample
  };
  static Step StepFrom(const PathFront& front, const PathFront::Scattered& scattered, std::uint32_t point) {
    return {front.points[point], scattered.lobe[point], scattered.pdfs[point]};
  }
  /// A ray from a point of a front that hits nothing.
  struct Escaping {
    std::uint32_t from;  // number of the point
    R3::Vector direction;
    R2::Color throughput;
    int record;  // as in PathState
  };
  /// The sampling methods that find light which rays can hit.
  struct Sampled {
    bool lights, bsdf;

    /// Returns the MIS weight of a direction from BSDF sampling; light sampling has the rest.
    double WeightOfBsdf(double bsdf_pdf, double light_pdf) const {
      if (!bsdf) return 0;
      return lights ? MisWeight(bsdf_pdf, light_pdf) : 1;
    }
  };
  // Random keys below a surface's own. Lights follow, with one key each.
  enum Key : std::uint64_t { bounce_key, scatter_key, next_event_key };
  static std::uint64_t KeyOf(int light) { return next_event_key + static_cast<std::uint64_t>(light); }

  /// Computes Li for at most R1::batch_size samples.
  ///   first_sample   the number of the first one among those of Li
  void TraceTogether(std::span<const CameraSample> samples, std::span<R2::Color> radiances, std::size_t first_sample,
                     TraceState& state) const;
  /// Finds the surfaces that camera rays hit. Sets radiances to their emission and reflected ambient light, or to the
  /// background.
  void SeeFirstSurfaces(std::span<const CameraSample> samples, std::span<R2::Color> radiances, PathFront& front,
                        TraceState& state) const;

  // Adds direct light at the points of a front, times the throughput, to state.arrived.
  void SampleLights(PathFront& front, TraceState& state) const;
  void SampleLight(int light, const PathFront& front, TraceState& state) const;
  /// Samples an emissive shape whose emission is a color, point by point.
  void SampleLamp(int lamp, const PathFront& front, const PointBatch<2>& random, TraceState& state) const;
  /// Converts light samples with pdfs to reflected light.
  void Reflect(const PathFront& front, const LightSamples::Each& pdfs, LightSamples& samples) const;
  /// Converts samples of one of the scene language's lights to reflected light.
  void ReflectByPhong(const PathFront& front, LightSamples& samples) const;
  /// Samples a few lights for each point, chosen by importance sampling.
  void SampleChosenLights(const PathFront& front, TraceState& state) const;
  void SampleChosenLights(const ShadingPoint& p, const Bsdf& bsdf, std::size_t index, TraceState& state) const;
  bool SamplesAllLights() const { return lights_at_once_ == 0; }
  /// Returns the light that p reflects of an unoccluded light sample.
  R2::Color Reflected(const ShadingPoint& p, const Bsdf& bsdf, const LightSample& light) const;
  /// Adds a shadow ray for the sample; `index` is the number of its point.
  void AddLightSample(const ShadingPoint& p, const R2::Color& reflected, const LightSample& light, std::size_t index,
                      TraceState& state) const;

  // How paths continue.
  /// Traces paths to the surfaces that they hit next, which are added to `next`. Adds the light that they find to
  /// `gathered`, by path.
  void TakeStep(const PathFront& front, std::span<R2::Color> gathered, PathFront& next, TraceState& state) const;
  PathFront::Scattered SampleBsdfs(const PathFront& front) const;
  /// Samples how a path continues from point number `i`, whose Bsdf this is, unless it ends there.
  ///   choices   uniform in [0, 1): two for a direction, one for a lobe, one for Russian roulette; `scattered` contains
  ///             the direction that the diffuse lobe makes of the first two
  void SampleBsdf(const ShadingPoint& p, std::uint32_t i, const Bsdf& bsdf, const std::array<double, 4>& choices,
                  PathFront::Scattered& scattered) const;
  /// Follows the rays of one lobe, which are stored in state.batch from number `first` on. Adds surfaces that they hit
  /// to `next`, and rays that hit nothing to `escaping`. Returns the number of rays.
  std::uint32_t Follow(const PathFront& front, const PathFront::Scattered& scattered, Lobe lobe, std::uint32_t first,
                       PathFront& next, std::vector<Escaping>& escaping, TraceState& state) const;
  /// Traces a ray from each point that scatters by the lobe, unless it could find no light. Stores rays in state.batch
  /// from number `first` on, and their hits in state.hits.
  ///   returns   the numbers of the points that they come from
  std::vector<std::uint32_t> TraceFrom(const PathFront& front, const PathFront::Scattered& scattered, Lobe lobe,
                                       std::uint32_t first, TraceState& state) const;
  /// Adds the background for rays that hit nothing.
  void AddBackgrounds(const PathFront& front, const PathFront::Scattered& scattered, std::span<const Escaping> escaping,
                      std::span<R2::Color> gathered, TraceState& state) const;
  R2::Color EnvironmentSeen(const Environment::Seen& seen, const Step& step, const R2::Color& throughput,
                            TraceState& state) const;
  /// Adds the emission and the ambient light of the surfaces that rays have hit.
  void AddEmitted(const PathFront& front, const PathFront::Scattered& scattered, const PathFront& next,
                  std::span<R2::Color> gathered, TraceState& state) const;
  /// Returns the emission of the surface that a scattered ray hit, times throughput, weighted against SampleLights.
  R2::Color Emitted(const Step& step, const ShadingPoint& hit) const;

  // How paths share light.
  /// Adds first and second surfaces to state.shared. What paths of `next` gather from then on is the light that their
  /// second surfaces send back, times the luminance of their throughput.
  void Share(const PathFront& front, PathFront& next, std::size_t first_sample, std::span<R2::Color> gathered,
             TraceState& state) const;
  bool SharesAsFirst(const PathFront& front, std::uint32_t point) const;

  // How paths end.
  bool IsLast(const ShadingPoint& p) const { return p.path.depth >= settings_.max_depth; }
  /// Returns true if a path that continues from a point of this depth may find light.
  bool MayContinue(const ShadingPoint& p) const { return !IsLast(p) || lights_.CanBeHit(); }
  /// Returns true if a ray may find light; the last ray of a path is traced only then.
  bool MayFindLight(const ShadingPoint& from, const R3::Ray& ray) const {
    return !IsLast(from) || lights_.MayBeHitBy(ray);
  }
  /// Returns the minimum survival probability of a path at a depth in Russian roulette; 1 without roulette.
  double LeastSurvival(std::int64_t depth) const;
  /// Counts the throughput that is lost if max_depth ends a path.
  void CountCutThroughput(const ShadingPoint& p, TraceState& state) const;
  /// Counts the path as a caustic if the emission that its step found makes it one.
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

#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "source/integrate/Bsdf.h"
#include "source/integrate/Integrator.h"
#include "source/integrate/Tracer.h"
#include "source/integrate/lights/Caustics.h"
#include "source/integrate/lights/LightSampler.h"

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
///   source   Kajiya, The rendering equation (1986), eq. 6; Cook, Porter, Carpenter, Distributed ray tracing (1984);
///            light and BSDF sampling combined by multiple importance sampling, see MisWeight; Russian roulette after
///            Arvo and Kirk (1990)
class Path : public Integrator {
 public:
  Path(const World& world, const Accelerator& accelerator, const TraceSettings& settings);

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 protected:
  /// A ray that goes on from a point, and what chose it.
  struct Step {
    PathState path;
    Lobe lobe;
    double pdf;  // of its direction, as of a BsdfSample
  };
  /// What a point's way on is chosen by, in [0, 1): two for a direction, one for a lobe, one for Russian roulette.
  using Choices = std::array<double, 4>;

  /// What a camera ray's surface gives of itself: its emission and what it reflects of ambient light.
  R2::Color EmittedAndAmbient(const ShadingPoint& p, TraceState& state) const;
  /// Whether light may be found by going on from points of this depth.
  bool MayContinue(const ShadingPoint& p) const { return !IsLast(p) || lights_.CanBeHit(); }
  bool IsLast(const ShadingPoint& p) const { return p.path.depth >= settings_.max_depth; }
  /// Counts what is cut off at a point of the last depth.
  void CountCutThroughput(const ShadingPoint& p, TraceState& state) const;
  /// Nothing for a path that ends here. `diffuse`: DiffuseDirection of the first two choices.
  std::optional<Step> SampleBsdf(const ShadingPoint& p, const Bsdf& bsdf, const Choices& choices,
                                 const R3::Vector& diffuse) const;
  /// What the step's ray sees where it hits nothing, throughput included.
  R2::Color BackgroundSeen(const ShadingPoint& from, const Step& step, TraceState& state) const;
  /// The same where the environment shines and what is seen of it is known.
  R2::Color EnvironmentSeen(const Environment::Seen& seen, const ShadingPoint& from, const Step& step,
                            TraceState& state) const;
  /// Adds what it sees of the surface that it hits.
  void AddEmitted(const ShadingPoint& from, const Step& step, const ShadingPoint& hit, R2::Color& radiance,
                  TraceState& state) const;
  /// Counts the path where what its step found makes it one.
  void CountCaustic(const Step& step, const R2::Color& emission, TraceState& state) const {
    if (IsSpecular(step.lobe) && step.path.is_scattered) state.rays.caustics += caustics_.Counts(emission);
  }

  /// The step where a direction has been chosen, and what throughput survives, which is not black.
  Step ExtendPath(const ShadingPoint& p, const R3::Vector& wi, Lobe lobe, double pdf,
                  const R2::Color& throughput) const {
    return {Extend(p, wi, lobe, throughput, p.path.index.Child(bounce_key)), lobe, pdf};
  }
  /// Whether it may find light; the last one of a path ends where none is seen.
  bool MayFindLight(const ShadingPoint& from, const Step& step) const {
    return !IsLast(from) || lights_.MayBeHitBy(step.path.ray);
  }
  /// With what probability a path survives Russian roulette, which from points of a depth is at least so much: 1 where
  /// none is played.
  double LeastSurvival(std::int64_t depth) const;
  static double SurvivalProbability(const R2::Color& throughput) {
    return std::min(1.0, std::max(std::max(throughput.r, throughput.g), throughput.b) / least_certain_throughput);
  }

  /// What p reflects of a sample on a light, if nothing is in between.
  R2::Color Reflected(const ShadingPoint& p, const Bsdf& bsdf, const LightSample& light) const;
  /// The same, throughput included, as a shadow ray; `index` is where it arrives.
  void AddLightSample(const ShadingPoint& p, const R2::Color& reflected, const LightSample& light, std::size_t index,
                      TraceState& state) const;
  /// From some lights, chosen by importance sampling.
  void SampleChosenLights(const ShadingPoint& p, const Bsdf& bsdf, std::size_t index, TraceState& state) const;
  bool SamplesAllLights() const { return lights_at_once_ == 0; }
  /// The MIS weight of one of two ways to sample the same direction: the balance heuristic, but of pdfs less than a
  /// tenth as large as the other's, where the cutoff heuristic gives nothing, smoothly less. A lamp that one BSDF sample
  /// in a hundred meets is noise in the pixels that meet it, and light samples do as well without. Against the balance
  /// heuristic, direct light from a small lamp has .92 of the error, eight other scenes within 1 % as much; by the power
  /// heuristic .91, and up to 1.04 under skies.
  ///   source   Veach and Guibas, Optimally combining sampling techniques (1995), section 3.4
  static double MisWeight(double pdf, double other_pdf) {
    constexpr double per_cutoff = 10;
    const bool is_lesser = pdf < other_pdf;
    const double ratio = is_lesser ? pdf / other_pdf : other_pdf / pdf, above_cutoff = per_cutoff * ratio;
    const double lesser = ratio * (above_cutoff < 1 ? above_cutoff : 1), share = lesser / (1 + lesser);
    return is_lesser ? share : 1 - share;
  }
  /// By what light that rays can hit is found.
  struct Sampled {
    bool lights, bsdf;

    /// Of BSDF sampling; light sampling has the rest.
    double WeightOfBsdf(double bsdf_pdf, double light_pdf) const {
      if (!bsdf) return 0;
      return lights ? MisWeight(bsdf_pdf, light_pdf) : 1;
    }
  };

  // What the keys beneath a surface are for. Lights follow, one each.
  enum Key : std::uint64_t { bounce_key, scatter_key, next_event_key };
  static std::uint64_t KeyOf(int light) { return next_event_key + static_cast<std::uint64_t>(light); }

  const World& world_;
  Tracer tracer_;
  TraceSettings settings_;
  LightSampler lights_;
  Caustics caustics_;
  Sampled sampled_;

 private:
  /// All light that reaches p over further bounces, throughput included; `p` is moved along the path.
  R2::Color IndirectLight(ShadingPoint&& p, TraceState& state) const;
  /// Light that reaches p straight from lights, throughput included.
  R2::Color DirectLight(const ShadingPoint& p, const Bsdf& bsdf, TraceState& state) const;
  /// The same as shadow rays; `index` is where it arrives.
  void SampleLights(const ShadingPoint& p, const Bsdf& bsdf, std::size_t index, TraceState& state) const;
  /// Emission of what a scattered ray hit, throughput included, weighted against SampleLights.
  R2::Color Emitted(const ShadingPoint& from, const Step& step, const ShadingPoint& hit) const;

  // Russian roulette begins with paths that carry less than this: what it would save before is not worth its noise.
  // With 1 instead of a quarter, 16 samples a pixel are 1.2 to 1.8 times less efficient (1 / (relative squared error
  // times seconds)) on five scenes, closed rooms and open ones; without roulette closed rooms are, 1.1 to 1.2 times.
  static constexpr double least_certain_throughput = 0.25;

  bool has_roulette_;
  int lights_at_once_;  // 0: all
};

}  // namespace ray

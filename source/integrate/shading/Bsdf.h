#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "R1/Elementary.h"
#include "R2/Color.h"
#include "R2/Point.h"
#include "R3/Vector.h"
#include "R3/Warp.h"
#include "source/integrate/TraceSettings.h"
#include "source/integrate/shading/Coat.h"
#include "source/integrate/shading/ShadingPoint.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// How much light a clear surface between two indices of refraction reflects, of both polarizations alike.
///   cosine    of the angle to the normal on the side the light comes from, in [0, 1]
///   eta       index on that side over the index on the other; > 0
///   returns   in [0, 1]; 1 on total internal reflection
///   source    Fresnel (1823), in the form of Born and Wolf, Principles of optics (1959), section 1.5.2
double FresnelReflectance(double cosine, double eta);

/// kd, or what a clear coat leaves of it for light at an angle of this cosine to N, in (0, 1].
inline R2::Color DiffuseReflectance(const ShadingPoint& p, double cosine) {
  if (p.material->coat == 0) [[likely]]
    return p.kd;
  return Coat(p.material->coat).DiffuseShare(std::min(1.0, cosine), std::clamp(Dot(p.N, p.wo), 0.0, 1.0)) * p.kd;
}

/// The diffuse lobe in the units of the scene language: kd (N.L), nothing from below. Times 1 / pi it is the BRDF of
/// Lambert, Photometria (1760), with its cosine.
///   L   unit, towards the light
inline R2::Color DiffuseReflection(const ShadingPoint& p, const R3::Vector& L) {
  const double cosine = std::max(0.0, Dot(p.N, L));
  return cosine * DiffuseReflectance(p, cosine);
}

/// Chooses by channel, since choosing between whole colors is a branch.
inline R2::Color Chosen(bool first, const R2::Color& a, const R2::Color& b) {
  return {first ? a.r : b.r, first ? a.g : b.g, first ? a.b : b.b};
}

/// V.R of a light towards L.
inline double LobeCosine(const R3::Vector& wo, const R3::Vector& N, const R3::Vector& L) {
  return Dot(wo, 2 * Dot(N, L) * N - L);
}
inline double LobeCosine(const ShadingPoint& p, const R3::Vector& L) { return LobeCosine(p.wo, p.N, L); }

/// Phong's highlight of a light towards L: ks (V.R)^n, nothing when V.R <= 0.
[[gnu::always_inline]] inline R2::Color Highlight(const ShadingPoint& p, const R3::Vector& L) {
  const double lobe = LobeCosine(p, L);
  const Material& m = *p.material;
  return p.Mapped(m.ks * (lobe > 0 && !IsBlack(m.ks) ? R1::CosinePower(lobe, m.n) : 0));
}

/// What a surface reflects of a light of the scene language, in its units (no 1/pi, no normalized lobe):
///     (kd (N.L) + ks (V.R)^n) I_L,   nothing when N.L <= 0, no lobe when V.R <= 0
///   cosine    N.L
///   kd        what a coat leaves of it
///   lobe      ks (V.R)^n
///   source    Phong, Illumination for computer generated pictures (1975)
inline R2::Color PhongSum(double cosine, const R2::Color& kd, const R2::Color& lobe, const R2::Color& irradiance) {
  return Chosen(cosine > 0, (cosine * kd + lobe) * irradiance, {});
}
/// What a point reflects by Phong's formula.
///   L   unit, towards the light; V is p.wo, R the mirror image of L about N
inline R2::Color PhongReflection(const ShadingPoint& p, const R3::Vector& L, const R2::Color& irradiance) {
  const double cosine = Dot(p.N, L);
  if (!(cosine > 0)) return {};
  return PhongSum(cosine, DiffuseReflectance(p, cosine), Highlight(p, L), irradiance);
}


/// What a surface reflects and what goes through it, as shares of the radiance: kr and kt, or with Fresnel's equations
/// a part of kt moved from the one to the other, all of it on total internal reflection. A coat mirrors its own share
/// and leaves these the rest.
struct SpecularWeights {
  R2::Color reflected, transmitted;
};
SpecularWeights SpecularWeightsOf(const ShadingPoint& p, const TraceSettings& settings);
/// Whether surfaces of a material have the diffuse lobe alone. Of their Bsdf, Eval is CosineHemispherePdf times kd, Pdf
/// is CosineHemispherePdf where kd is not black and else 0, and Sample gives the diffuse direction.
inline bool IsDiffuse(const Material& m) { return m.coat == 0 && IsBlack(m.kr) && IsBlack(m.kt); }
/// Their sum, 0 for what is diffuse alone.
inline R2::Color SpecularReflectance(const ShadingPoint& p, const TraceSettings& settings) {
  if (IsDiffuse(*p.material)) return {};
  const SpecularWeights shares = SpecularWeightsOf(p, settings);
  return shares.reflected + shares.transmitted;
}

/// Whether reflections are spread over Phong's lobe, and the lobe's exponent then.
inline bool IsGlossy(const Material& m, const TraceSettings& settings) { return settings.glossy || m.gloss > 0; }
inline double GlossExponent(const Material& m) { return m.gloss > 0 ? m.gloss : m.n; }
/// Whether highlights or the non-specular lobes of a Bsdf may reflect light, so that lights are worth sampling.
inline bool ReflectsLights(const ShadingPoint& p, const TraceSettings& settings) {
  return p.HasReflectance() || (IsGlossy(*p.material, settings) && !IsBlack(SpecularWeightsOf(p, settings).reflected));
}

/// wo mirrored about N and never into the surface, or with a glossy reflection a direction of Phong's lobe around that.
///   u         uniform in [0, 1)^2
///   returns   a unit vector; nothing where one of the lobe leads below N's horizon or into the surface
std::optional<R3::Vector> SampleReflection(const ShadingPoint& p, bool glossy, const R2::Point& u);
/// The direction on the other side: straight on for an index of 1, else refracted; unit. Nothing on total internal
/// reflection. A smoothed normal that faces away from wo is taken to be at a right angle to it.
std::optional<R3::Vector> Refraction(const ShadingPoint& p);

/// A direction of the diffuse lobe about N.
inline R3::Vector DiffuseDirection(const R3::Vector& N, const R2::Point& u) {
  return R3::FromTangents(R3::SampleCosineHemisphere(u), N);
}

/// The lobes of a BSDF. A specular one is a delta distribution: it scatters into one direction alone.
enum class Lobe { diffuse, glossy, mirror, transmission };
inline constexpr std::size_t lobes = 4;
constexpr bool IsSpecular(Lobe lobe) { return lobe == Lobe::mirror || lobe == Lobe::transmission; }
/// The rays that it sends on.
constexpr RayKind KindOf(Lobe lobe) {
  switch (lobe) {
    case Lobe::diffuse:
      return RayKind::diffuse;
    case Lobe::glossy:
    case Lobe::mirror:
      return RayKind::reflection;
    case Lobe::transmission:
      return RayKind::transmission;
  }
  return {};
}

/// A direction that light may come from. value / pdf estimates the reflectance.
struct BsdfSample {
  R3::Vector wi;    // unit
  R2::Color value;  // BSDF times cosine: Eval(wi); of a specular lobe its share of the radiance
  double pdf = 0;   // Pdf(wi); of a specular lobe the probability of choosing it
  Lobe lobe = Lobe::diffuse;
};

/// How the surface at a point scatters light towards wo: kd / pi, a glossy lobe or a mirror of weight kr, and kt
/// straight on or refracted, kr and kt being the SpecularWeights. The glossy lobe is Phong's, normalized over the
/// hemisphere about R, wo mirrored about N. Radiance that it scatters per radiance and solid angle is
///
///     kr (n + 1) / (2 pi) (wi.R)^n,   nothing where wi.R <= 0 or wi.N <= 0,
///
/// and no cosine wi.N is in it: it is the BRDF times that cosine. What is below the surface is lost, so that with wo at
/// an angle t to N it reflects of an evenly lit hemisphere
///
///     kr * integral of cos^n from t - pi/2 to pi/2 / integral of cos^n from -pi/2 to pi/2:
///
/// kr from straight above, half of it at the horizon. A lobe with the cosine and the norm (n + 2) / (2 pi), as other
/// renderers have it, is as strong from straight above and (n + 2) / (n + 1) cos t times as strong in the middle at an
/// angle t, so that the same kr looks fainter there.
///
/// wo is fixed when a Bsdf is made, because Fresnel's share and the middle of the lobe depend on it alone. The point
/// must outlive it. Directions are unit and point away from the surface.
///   source   Phong (1975) for the lobe; Lafortune, Willems, Using the modified Phong reflectance model for physically
///            based rendering (1994), eq. 4 for the norm, theirs with the cosine
class Bsdf {
 public:
  Bsdf(const ShadingPoint& p, const TraceSettings& settings);

  /// The non-specular lobes: radiance scattered to wo per radiance from wi and solid angle, the cosine included.
  R2::Color Eval(const R3::Vector& wi) const { return EvalWithPdf(wi).value; }
  /// The pdf, per solid angle, with which Sample gives wi by a non-specular lobe.
  double Pdf(const R3::Vector& wi) const { return EvalWithPdf(wi).pdf; }
  /// Both, for the price of one: the glossy lobe takes a power.
  struct ValueAndPdf {
    R2::Color value;
    double pdf;
  };
  ValueAndPdf EvalWithPdf(const R3::Vector& wi) const;
  /// Importance sampling: a lobe with a probability proportional to the luminance of its weight, then a direction by
  /// that lobe. Nothing where no light is scattered, or it would have to come from inside the surface.
  ///   u, choice   uniform in [0, 1)
  std::optional<BsdfSample> Sample(const R2::Point& u, double choice) const {
    return Sample(u, choice, DiffuseDirection(p_.N, u));
  }
  /// Sample for callers that know DiffuseDirection(N, u).
  std::optional<BsdfSample> Sample(const R2::Point& u, double choice, const R3::Vector& diffuse) const;

 private:
  std::optional<BsdfSample> Scatter(const R3::Vector& wi, Lobe lobe) const;

  const ShadingPoint& p_;
  SpecularWeights specular_;
  double diffuse_ = 0, reflection_ = 0, transmission_ = 0;  // probabilities; their sum is 1, or 0 for a black surface
  bool is_glossy_;
  R3::Vector mirrored_;  // the middle of the glossy lobe, where there is one
};

/// A path extended from p along a ray that SpawnRay has made, in a direction that the lobe has given.
inline PathState Extend(const ShadingPoint& p, Lobe lobe, const R2::Color& throughput, const SampleIndex& index) {
  return {.throughput = throughput,
          .depth = p.path.depth + 1,
          .index = index,
          .kind = KindOf(lobe),
          .is_scattered = p.path.is_scattered || !IsSpecular(lobe),
          .media = lobe == Lobe::transmission ? p.media_beyond : p.path.media,
          .record = p.path.record};
}

}  // namespace ray

#pragma once

#include <algorithm>
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

/// Returns the fraction of light that a clear surface between two indices of refraction reflects, averaged over both
/// polarizations.
///   cosine    of the angle to the normal on the side the light comes from, in [0, 1]
///   eta       index on that side over the index on the other; > 0
///   returns   in [0, 1]; 1 on total internal reflection
///   source    Fresnel (1823), in the form of Born and Wolf, Principles of optics (1959), section 1.5.2
double FresnelReflectance(double cosine, double eta);

/// Returns kd, reduced by a clear coat for light at an angle of this cosine to N, in (0, 1].
inline R2::Color DiffuseReflectance(const ShadingPoint& p, double cosine) {
  if (p.material->coat == 0) [[likely]]
    return p.kd;
  return Coat(p.material->coat).DiffuseShare(std::min(1.0, cosine), std::clamp(Dot(p.N, p.wo), 0.0, 1.0)) * p.kd;
}

/// Evaluates the diffuse lobe in the units of the scene language: kd (N.L), 0 from below. Times 1 / pi it is the BRDF
/// of Lambert, Photometria (1760), with its cosine.
///   L   unit, towards the light
inline R2::Color DiffuseReflection(const ShadingPoint& p, const R3::Vector& L) {
  const double cosine = std::max(0.0, Dot(p.N, L));
  return cosine * DiffuseReflectance(p, cosine);
}

/// Selects per channel, since g++ turns a choice of whole colors into a branch.
inline R2::Color Chosen(bool first, const R2::Color& a, const R2::Color& b) {
  return {first ? a.r : b.r, first ? a.g : b.g, first ? a.b : b.b};
}

/// Returns V.R of a light towards L.
inline double LobeCosine(const R3::Vector& wo, const R3::Vector& N, const R3::Vector& L) {
  return Dot(wo, 2 * Dot(N, L) * N - L);
}
inline double LobeCosine(const ShadingPoint& p, const R3::Vector& L) { return LobeCosine(p.wo, p.N, L); }

/// Evaluates Phong's highlight of a light towards L: ks (V.R)^n, 0 if V.R <= 0.
[[gnu::always_inline]] inline R2::Color Highlight(const ShadingPoint& p, const R3::Vector& L) {
  const double lobe = LobeCosine(p, L);
  const Material& m = *p.material;
  return p.Mapped(m.ks * (lobe > 0 && !IsBlack(m.ks) ? R1::CosinePower(lobe, m.n) : 0));
}

/// Returns the light that a surface reflects of a light of the scene language, in its units (no 1/pi, no normalized
/// lobe):
///     (kd (N.L) + ks (V.R)^n) I_L,   0 if N.L <= 0, no lobe if V.R <= 0
///   cosine    N.L
///   kd        reduced by a coat
///   lobe      ks (V.R)^n
///   source    Phong, Illumination for computer generated images (1975)
inline R2::Color PhongSum(double cosine, const R2::Color& kd, const R2::Color& lobe, const R2::Color& irradiance) {
  return Chosen(cosine > 0, (cosine * kd + lobe) * irradiance, {});
}
/// Returns the light that a point reflects by Phong's formula.
///   L   unit, towards the light; V is p.wo, R the mirror image of L about N
inline R2::Color PhongReflection(const ShadingPoint& p, const R3::Vector& L, const R2::Color& irradiance) {
  const double cosine = Dot(p.N, L);
  if (!(cosine > 0)) return {};
  return PhongSum(cosine, DiffuseReflectance(p, cosine), Highlight(p, L), irradiance);
}

/// The reflected and transmitted fractions of the radiance: kr and kt, or with Fresnel's equations a part of kt moved
/// from the latter to the former, all of it on total internal reflection. A coat reflects its own share and reduces
/// these.
struct SpecularWeights {
  R2::Color reflected, transmitted;
};
SpecularWeights SpecularWeightsOf(const ShadingPoint& p, const TraceSettings& settings);
/// Returns true if surfaces of a material have only the diffuse lobe. Their Bsdf has Eval CosineHemispherePdf times kd,
/// Pdf CosineHemispherePdf (0 if kd is black), and Sample returns the diffuse direction.
inline bool IsDiffuse(const Material& m) { return m.coat == 0 && IsBlack(m.kr) && IsBlack(m.kt); }
/// Returns the sum of the specular weights, 0 for purely diffuse surfaces.
inline R2::Color SpecularReflectance(const ShadingPoint& p, const TraceSettings& settings) {
  if (IsDiffuse(*p.material)) return {};
  const SpecularWeights shares = SpecularWeightsOf(p, settings);
  return shares.reflected + shares.transmitted;
}

/// Returns true if reflections are spread over Phong's lobe.
inline bool IsGlossy(const Material& m, const TraceSettings& settings) { return settings.glossy || m.gloss > 0; }
inline double GlossExponent(const Material& m) { return m.gloss > 0 ? m.gloss : m.n; }
/// Returns true if highlights or the non-specular lobes of a Bsdf may reflect light, so that lights are worth sampling.
inline bool ReflectsLights(const ShadingPoint& p, const TraceSettings& settings) {
  return p.HasReflectance() || (IsGlossy(*p.material, settings) && !IsBlack(SpecularWeightsOf(p, settings).reflected));
}

/// Returns wo mirrored about N and never into the surface, or with a glossy reflection a direction of Phong's lobe
/// around that.
///   u         uniform in [0, 1)^2
///   returns   a unit vector; std::nullopt if one of the lobe is below N's horizon or inside the surface
std::optional<R3::Vector> SampleReflection(const ShadingPoint& p, bool glossy, const R2::Point& u);
/// Returns the direction on the other side: straight for an index of 1, otherwise refracted; unit. Returns std::nullopt
/// on total internal reflection. A smoothed normal that faces away from wo is treated as perpendicular to it.
std::optional<R3::Vector> Refraction(const ShadingPoint& p);

/// Samples a direction of the diffuse lobe about N.
inline R3::Vector DiffuseDirection(const R3::Vector& N, const R2::Point& u) {
  return R3::FromTangents(R3::SampleCosineHemisphere(u), N);
}

/// The lobes of a BSDF. A specular one is a delta distribution: it scatters into a single direction.
enum class Lobe { diffuse, glossy, mirror, transmission };
inline constexpr std::size_t lobes = 4;
constexpr bool IsSpecular(Lobe lobe) { return lobe == Lobe::mirror || lobe == Lobe::transmission; }
/// Returns the kind of the rays that a lobe scatters.
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

/// A direction from which light may come. value / pdf estimates the reflectance.
struct BsdfSample {
  R3::Vector wi;    // unit
  R2::Color value;  // BSDF times cosine: Eval(wi); for a specular lobe its share of the radiance
  double pdf = 0;   // Pdf(wi); for a specular lobe the probability of choosing it
  Lobe lobe = Lobe::diffuse;
};

/// The scattering of light towards wo by the surface at a point: kd / pi, a glossy lobe or a mirror of weight kr, and
/// kt straight or refracted, with the SpecularWeights kr and kt. The glossy lobe is Phong's, normalized over the
/// hemisphere about R, which is wo mirrored about N. The scattered radiance per radiance and solid angle is
///
///     kr (n + 1) / (2 pi) (wi.R)^n,   0 if wi.R <= 0 or wi.N <= 0,
///
/// without a cosine wi.N: it is the BRDF times that cosine. Light below the surface is lost, so with wo at an angle t
/// to N the surface reflects of an evenly lit hemisphere
///
///     kr * integral of cos^n from t - pi/2 to pi/2 / integral of cos^n from -pi/2 to pi/2:
///
/// kr from straight above, half of it at the horizon. A lobe with the cosine and the norm (n + 2) / (2 pi), as in other
/// renderers, is equally strong from straight above and (n + 2) / (n + 1) cos t times as strong in the middle at an
/// angle t, so that the same kr looks fainter there.
///
/// wo is fixed when a Bsdf is made, because Fresnel's share and the middle of the lobe depend on it alone. The point
/// must outlive it. Directions are unit and point away from the surface.
///   source   Phong (1975) for the lobe; Lafortune, Willems, Using the modified Phong reflectance model for physically
///            based rendering (1994), eq. 4 for the norm, theirs with the cosine
class Bsdf {
 public:
  Bsdf(const ShadingPoint& p, const TraceSettings& settings);

  /// Evaluates the non-specular lobes: radiance scattered to wo per radiance from wi and solid angle, including the
  /// cosine.
  R2::Color Eval(const R3::Vector& wi) const { return EvalWithPdf(wi).value; }
  /// Returns the pdf, per solid angle, with which Sample returns wi by a non-specular lobe.
  double Pdf(const R3::Vector& wi) const { return EvalWithPdf(wi).pdf; }
  /// Both values, computed together: the glossy lobe requires a power.
  struct ValueAndPdf {
    R2::Color value;
    double pdf;
  };
  ValueAndPdf EvalWithPdf(const R3::Vector& wi) const;
  /// Importance sampling: chooses a lobe with a probability proportional to the luminance of its weight, then a
  /// direction by that lobe. Returns std::nullopt if no light is scattered, or it would have to come from inside the
  /// surface.
  ///   u, choice   uniform in [0, 1)
  std::optional<BsdfSample> Sample(const R2::Point& u, double choice) const {
    return Sample(u, choice, DiffuseDirection(p_.N, u));
  }
  /// A variant for callers that know DiffuseDirection(N, u).
  std::optional<BsdfSample> Sample(const R2::Point& u, double choice, const R3::Vector& diffuse) const;

 private:
  std::optional<BsdfSample> Scatter(const R3::Vector& wi, Lobe lobe) const;

  const ShadingPoint& p_;
  SpecularWeights specular_;
  double diffuse_ = 0, reflection_ = 0, transmission_ = 0;  // probabilities; their sum is 1, or 0 for a black surface
  bool is_glossy_;
  R3::Vector mirrored_;  // middle of the glossy lobe, if there is one
};

/// Returns a path extended from p along a ray that SpawnRay has made, in a direction that the lobe has given.
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

#include "source/integrate/shading/Bsdf.h"

#include "R3/Warp.h"
#include "source/integrate/shading/Refract.h"

namespace ray {
namespace {

/// Returns wo mirrored about N; if a smoothed normal directs that into the surface, mirrored back out of it.
R3::Vector Mirrored(const ShadingPoint& p) {
  const R3::Vector mirrored = Unit(Reflect(-p.wo, p.N));
  return p.IsBehindSurface(mirrored) ? Unit(Reflect(mirrored, p.Outward())) : mirrored;
}

}  // namespace

double FresnelReflectance(double cosine, double eta) {
  const double sine_squared = eta * eta * std::max(0.0, 1 - cosine * cosine);
  if (!(sine_squared < 1)) return 1;
  const double other = std::sqrt(1 - sine_squared);  // cosine behind the surface
  const double across = (eta * cosine - other) / (eta * cosine + other);
  const double along = (cosine - eta * other) / (cosine + eta * other);
  return (across * across + along * along) / 2;
}

namespace {

SpecularWeights WithoutCoat(const ShadingPoint& p, double cosine, const TraceSettings& settings) {
  const Material& m = *p.material;
  const R2::Color kr = p.Mapped(m.kr);
  if (!(settings.fresnel || settings.internal_reflection) || IsBlack(m.kt) || p.RelativeIndex() == 1) return {kr, m.kt};
  if (!settings.fresnel) return Refraction(p) ? SpecularWeights{kr, m.kt} : SpecularWeights{kr + m.kt, {}};
  const double share = FresnelReflectance(cosine, p.RelativeIndex());
  return {kr + share * m.kt, (1 - share) * m.kt};
}

}  // namespace

SpecularWeights SpecularWeightsOf(const ShadingPoint& p, const TraceSettings& settings) {
  const double coat = p.material->coat, cosine = std::clamp(Dot(p.N, p.wo), 0.0, 1.0);
  const SpecularWeights under = WithoutCoat(p, cosine, settings);
  if (!(coat > 0)) [[likely]]
    return under;
  const double mirrored = Coat(coat).Reflectance(cosine);
  return {mirrored * R2::Color{1, 1, 1} + (1 - mirrored) * under.reflected, (1 - mirrored) * under.transmitted};
}

namespace {

/// Samples a direction of Phong's lobe about `mirrored`; std::nullopt if it is below N's horizon or inside the surface.
std::optional<R3::Vector> SampleLobe(const ShadingPoint& p, const R3::Vector& mirrored, const R2::Point& u) {
  const R3::Vector wi = R3::FromTangents(R3::SamplePhongLobe(u, GlossExponent(*p.material)), mirrored);
  if (!(Dot(wi, p.N) > 0) || p.IsBehindSurface(wi)) return {};
  return wi;
}

}  // namespace

std::optional<R3::Vector> SampleReflection(const ShadingPoint& p, bool glossy, const R2::Point& u) {
  const R3::Vector mirrored = Mirrored(p);
  return glossy ? SampleLobe(p, mirrored, u) : mirrored;
}

std::optional<R3::Vector> Refraction(const ShadingPoint& p) {
  const double index = p.RelativeIndex();
  if (index == 1) return -p.wo;
  const double cosine = Dot(p.N, p.wo);
  const R3::Vector N = cosine < 0 ? Unit(p.N - cosine * p.wo) : p.N;
  return Refract(-p.wo, N, index);
}

Bsdf::Bsdf(const ShadingPoint& p, const TraceSettings& settings) : p_(p), specular_(SpecularWeightsOf(p, settings)) {
  const double d = Luminance(p.kd), r = Luminance(specular_.reflected), t = Luminance(specular_.transmitted);
  const double sum = d + r + t;
  if (sum > 0) {
    diffuse_ = d / sum;
    reflection_ = r / sum;
    transmission_ = t / sum;
  }
  is_glossy_ = IsGlossy(*p.material, settings) && r > 0;
  if (is_glossy_) mirrored_ = Mirrored(p);
}

Bsdf::ValueAndPdf Bsdf::EvalWithPdf(const R3::Vector& wi) const {
  const double cosine = Dot(p_.N, wi), diffuse_pdf = R3::CosineHemispherePdf(cosine);
  double pdf = diffuse_ * diffuse_pdf, glossy_pdf = 0;
  if (is_glossy_) {
    glossy_pdf = R3::PhongLobePdf(Dot(wi, mirrored_), GlossExponent(*p_.material));
    pdf += reflection_ * glossy_pdf;
  }
  if (!(cosine > 0)) return {{}, pdf};
  R2::Color value = diffuse_pdf * DiffuseReflectance(p_, cosine);
  if (is_glossy_) value += glossy_pdf * specular_.reflected;
  return {value, pdf};
}

std::optional<BsdfSample> Bsdf::Sample(const R2::Point& u, double choice, const R3::Vector& diffuse) const {
  if (choice < diffuse_) return Scatter(diffuse, Lobe::diffuse);
  if (choice < diffuse_ + reflection_) {
    if (!is_glossy_) return BsdfSample{Mirrored(p_), specular_.reflected, reflection_, Lobe::mirror};
    const auto wi = SampleLobe(p_, mirrored_, u);
    if (!wi) return {};
    return Scatter(*wi, Lobe::glossy);
  }
  if (!(transmission_ > 0)) return {};
  const auto wi = Refraction(p_);
  if (!wi) return {};
  return BsdfSample{*wi, specular_.transmitted, transmission_, Lobe::transmission};
}

/// Light that a glossy lobe or a smoothed normal directs into the surface is lost.
std::optional<BsdfSample> Bsdf::Scatter(const R3::Vector& wi, Lobe lobe) const {
  const auto [value, pdf] = EvalWithPdf(wi);
  if (!(pdf > 0) || !(Dot(p_.Outward(), wi) > 0)) return {};
  return BsdfSample{wi, value, pdf, lobe};
}

}  // namespace ray

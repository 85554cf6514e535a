#include "source/integrate/shading/Bsdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "source/integrate/shading/PhongColumns.h"
#include "tests/Draw.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;

Material MaterialOf(const R2::Color& kd, const R2::Color& ks, const R2::Color& kt, double n = 10, double ir = 1.5) {
  Material m;
  m.kd = kd, m.ks = m.kr = ks, m.kt = kt, m.n = n, m.ir = ir;
  return m;
}

/// Returns a point of a level surface seen from above, from outside or from within.
ShadingPoint PointOf(const Material& material, const R3::Vector& wo, bool entering = true) {
  ShadingPoint p({}, PathState{}, {});
  p.material = &material;
  p.kd = material.kd;
  p.wo = Unit(wo);
  p.entering = entering;
  p.N = {0, 1, 0};
  p.at.normal = R3::AsNormal(entering ? p.N : -p.N);
  return p;
}

TraceSettings SettingsOf(bool glossy, bool fresnel = false) {
  TraceSettings settings;
  settings.glossy = glossy;
  settings.fresnel = fresnel;
  return settings;
}

/// Returns the direction with these angles to the normal and around it.
R3::Vector Direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// Integrates f over the hemisphere about the normal, by the midpoint rule.
template <typename F>
double OverHemisphere(const F& f) {
  constexpr int steps = 400;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double theta = (i + 0.5) * pi / 2 / steps, phi = (j + 0.5) * 2 * pi / steps;
      sum += f(Direction(theta, phi)) * std::sin(theta);
    }
  return sum * (pi / 2 / steps) * (2 * pi / steps);
}

const R3::Vector slanted = Unit(R3::Vector{0.6, 0.7, -0.2});

TEST(Bsdf, BatchedPhongEqualsSingleSamplesBitForBit) {
  for (const double n : {0.0, 1.0, 7.5, 20.0, 1000.0, 1024.0, 1025.0, 1e9})
    for (const double coat : {0.0, 1.5})
      for (const double length : {1.0, 1e200}) {
        Material m = MaterialOf({0.4, 0.3, 0}, {0.3, 0.2, 0.1}, {}, n);
        m.coat = coat;
        const ShadingPoint p = PointOf(m, slanted);
        LightSamples samples, before;
        samples.count = 37;
        for (std::uint32_t i = 0; i < samples.count; ++i)  // some of them from below
          samples.Set(i, length * Direction(0.06 * i, 2.4 * i), {1.0 + i, 0.5, i % 5 == 0 ? 0.0 : 2.0});
        samples.Set(3, length * (2 * Dot(p.N, p.wo) * p.N - p.wo), {1, 1, 1});  // in the middle of the highlight
        before = samples;
        ReflectByPhong(p, 1, samples);
        for (std::uint32_t i = 0; i < samples.count; ++i)
          EXPECT_EQ(samples.color[i], PhongReflection(p, Unit(before.to_light[i]), before.color[i]))
              << "exponent " << n << ", sample " << i;
      }
}

TEST(Bsdf, HighlightsOfWholeExponentsAreExactWithinRounding) {
  for (const double n : {1.0, 2.0, 3.0, 20.0, 255.0, 1000.0, 1024.0})
    for (const double cosine : {0.1, 0.5, 0.9, 0.99, 0.9999, 1.0}) {
      const double truth = static_cast<double>(std::pow(static_cast<long double>(cosine), static_cast<long double>(n)));
      EXPECT_NEAR(R1::CosinePower(cosine, n), truth, n * 0x1p-53 * truth + 0x1p-1060) << cosine << "^" << n;
    }
}

TEST(Bsdf, SamplesAgreeWithEvalAndPdf) {
  const Material m = MaterialOf({0.4, 0.3, 0.2}, {0.3, 0.2, 0.1}, {0.1, 0.2, 0.3});
  for (const bool glossy : {false, true}) {
    const ShadingPoint p = PointOf(m, slanted);
    const Bsdf bsdf(p, SettingsOf(glossy));
    int lobes[4] = {};
    for (double u = 0.01; u < 1; u += 0.07)
      for (double v = 0.02; v < 1; v += 0.09)
        for (double choice = 0.03; choice < 1; choice += 0.05) {
          const auto sample = bsdf.Sample({u, v}, choice);
          if (!sample) continue;
          ++lobes[static_cast<int>(sample->lobe)];
          EXPECT_NEAR(Length(sample->wi), 1, 1e-14);
          if (IsSpecular(sample->lobe)) continue;
          EXPECT_EQ(sample->pdf, bsdf.Pdf(sample->wi));
          EXPECT_EQ(sample->value, bsdf.Eval(sample->wi));
          EXPECT_GT(Dot(sample->wi, p.N), 0);
        }
    EXPECT_GT(lobes[static_cast<int>(Lobe::diffuse)], 0);
    EXPECT_GT(lobes[static_cast<int>(Lobe::transmission)], 0);
    EXPECT_EQ(lobes[static_cast<int>(Lobe::glossy)] > 0, glossy);
    EXPECT_EQ(lobes[static_cast<int>(Lobe::mirror)] > 0, !glossy);
  }
}

TEST(Bsdf, InAWhiteFurnaceItsSamplesReturnItsReflectances) {
  const Material m = MaterialOf({0.4, 0.3, 0.2}, {0.3, 0.2, 0.1}, {0.1, 0.2, 0.3});
  const ShadingPoint p = PointOf(m, slanted);
  for (const bool fresnel : {false, true}) {
    const Bsdf bsdf(p, SettingsOf(false, fresnel));
    constexpr int count = 20000;
    R2::Color sum;
    for (int i = 0; i < count; ++i)
      if (const auto sample = bsdf.Sample({0.25, 0.75}, (i + 0.5) / count)) sum += sample->value / sample->pdf;
    EXPECT_NEAR(sum.r / count, 0.8, 1e-3);
    EXPECT_NEAR(sum.g / count, 0.7, 1e-3);
    EXPECT_NEAR(sum.b / count, 0.6, 1e-3);
  }
}

TEST(Bsdf, TheDiffuseLobeReflectsKdAndIsReciprocal) {
  const Material m = MaterialOf({0.4, 0.3, 0.2}, {}, {});
  const ShadingPoint p = PointOf(m, slanted);
  const Bsdf bsdf(p, SettingsOf(false));
  EXPECT_NEAR(OverHemisphere([&](const R3::Vector& wi) { return bsdf.Eval(wi).g; }), 0.3, 1e-5);
  EXPECT_EQ(bsdf.Eval({0, -1, 0}), (R2::Color{}));
  for (double theta = 0.1; theta < 1.5; theta += 0.2) {
    const R3::Vector other = Direction(theta, 1);
    const ShadingPoint back = PointOf(m, other);
    EXPECT_NEAR(bsdf.Eval(other).r / other.y, Bsdf(back, SettingsOf(false)).Eval(slanted).r / slanted.y, 1e-15);
  }
}

TEST(Bsdf, PdfIntegratesToOneWhereNothingIsSpecularOrLost) {
  const Material m = MaterialOf({0.4, 0.3, 0.2}, {0.3, 0.2, 0.1}, {});
  const ShadingPoint p = PointOf(m, {0, 1, 0});  // so that no part of the glossy lobe is below the surface
  const Bsdf bsdf(p, SettingsOf(true));
  EXPECT_NEAR(OverHemisphere([&](const R3::Vector& wi) { return bsdf.Pdf(wi); }), 1, 1e-4);
  EXPECT_NEAR(OverHemisphere([&](const R3::Vector& wi) { return bsdf.Eval(wi).r; }), 0.7, 1e-4);
}

TEST(Bsdf, EvalIsLambertsAndPhongsNormalizedLobes) {
  const Material m = MaterialOf({0.4, 0.3, 0.2}, {0.3, 0.2, 0.1}, {}, 7);
  const ShadingPoint p = PointOf(m, slanted);
  const R3::Vector R{-slanted.x, slanted.y, -slanted.z};
  for (double theta = 0.05; theta < 1.5; theta += 0.1)
    for (double phi = 0; phi < 6; phi += 0.5) {
      const R3::Vector wi = Direction(theta, phi);
      const double lobe = std::pow(std::max(0.0, Dot(wi, R)), 7) * 8 / (2 * pi);
      EXPECT_NEAR(Bsdf(p, SettingsOf(true)).Eval(wi).r, 0.4 * wi.y / pi + 0.3 * lobe, 1e-13);
      EXPECT_NEAR(Bsdf(p, SettingsOf(false)).Eval(wi).r, 0.4 * wi.y / pi, 1e-15);
      // The scene language's formula has the same lobe, seen from the light, without the normalization.
      const R2::Color phong = PhongReflection(p, wi, {2, 2, 2});
      EXPECT_NEAR(phong.b, 2 * (0.2 * wi.y + 0.1 * std::pow(std::max(0.0, Dot(wi, R)), 7)), 1e-13);
    }
  EXPECT_EQ(PhongReflection(p, {0, -1, 0}, {2, 2, 2}), (R2::Color{}));
}

/// Integrates cos^n from `from` to pi/2, by parts.
double IntegralOfCosine(int n, double from) {
  if (n == 0) return pi / 2 - from;
  if (n == 1) return 1 - std::sin(from);
  return (n - 1.0) / n * IntegralOfCosine(n - 2, from) - std::pow(std::cos(from), n - 1) * std::sin(from) / n;
}

TEST(Bsdf, TheGlossyLobeReflectsKsAboveTheSurface) {
  // Around the axis that is perpendicular to R and N, the longitude of a direction alone decides whether it is above
  // the surface, and its cosine with R is that of the longitude times one of the latitude, which cancels.
  for (const int n : {0, 1, 2, 3, 10, 37})
    for (const double angle : {0.0, 0.3, 0.8, 1.2, 1.5}) {
      const Material m = MaterialOf({}, {0.6, 0.3, 0.1}, {}, n);
      const ShadingPoint p = PointOf(m, Direction(angle, 0.4));
      const Bsdf bsdf(p, SettingsOf(true));
      const double above = IntegralOfCosine(n, angle - pi / 2) / IntegralOfCosine(n, -pi / 2);
      const double lit_evenly = OverHemisphere([&](const R3::Vector& wi) { return bsdf.Eval(wi).r; });
      EXPECT_NEAR(lit_evenly, 0.6 * above, 2e-3) << "exponent " << n << ", angle " << angle;
      EXPECT_NEAR(bsdf.Eval(Direction(angle, 0.4 + pi)).r, 0.6 * (n + 1) / (2 * pi), 1e-12) << "no cosine";

      constexpr int steps = 300;
      double by_samples = 0;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
          if (const auto sample = bsdf.Sample({(i + 0.5) / steps, (j + 0.5) / steps}, 0.5))
            by_samples += sample->value.r / sample->pdf / (steps * steps);
      EXPECT_NEAR(by_samples, 0.6 * above, 3e-3) << "exponent " << n << ", angle " << angle;
    }
}

TEST(Bsdf, SmoothedMirrorsSendNothingIntoTheSurface) {
  const Material material = MaterialOf({}, {1, 1, 1}, {});
  Draw draw(41);
  int turned = 0;
  for (int i = 0; i < 1000; ++i) {
    ShadingPoint p = PointOf(material, draw.Direction(), draw.Whole(0, 1) == 0);
    if (p.wo.y < 0) p.wo.y = -p.wo.y;
    const R3::Vector normal = p.N;
    do p.N = Unit(normal + 0.8 * draw.Direction());
    while (!(Dot(p.N, p.wo) > 0));
    p.is_smoothed = true;
    const R3::Vector plain = 2 * Dot(p.N, p.wo) * p.N - p.wo;
    const auto sample = Bsdf(p, SettingsOf(false)).Sample({0.5, 0.5}, 0.5);
    ASSERT_TRUE(sample);
    EXPECT_NEAR(Length(sample->wi), 1, 1e-15);
    EXPECT_NEAR(sample->wi.y, std::abs(plain.y), 1e-14);
    EXPECT_NEAR(sample->wi.x, plain.x, 1e-14);
    turned += plain.y < 0;
    const auto blurred = SampleReflection(p, true, {draw.Between(0, 1), draw.Between(0, 1)});
    EXPECT_TRUE(!blurred || blurred->y > 0);
  }
  EXPECT_GT(turned, 50);
}

TEST(Bsdf, RefractsBySnellsLawIntoGlassAndOutAgain) {
  const Material glass = MaterialOf({}, {}, {1, 1, 1});
  const ShadingPoint p = PointOf(glass, {0.6, 0.8, 0});
  const auto into = Refraction(p);
  ASSERT_TRUE(into);
  EXPECT_NEAR(into->x, -0.4, 1e-15);  // the sine 0.6 over 1.5
  EXPECT_NEAR(into->y, -std::sqrt(0.84), 1e-15);
  const ShadingPoint within = PointOf(glass, {-0.4, std::sqrt(0.84), 0}, false);
  const auto out = Refraction(within);
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->x, 0.6, 1e-15);
  EXPECT_NEAR(out->y, -0.8, 1e-15);
}

TEST(Bsdf, BeyondTheCriticalAngleNothingIsTransmitted) {
  const Material glass = MaterialOf({}, {0.1, 0.1, 0.1}, {0.9, 0.9, 0.9});
  const ShadingPoint p = PointOf(glass, {0.8, 0.6, 0}, false);  // 1.5 * 0.8 > 1
  const Bsdf without(p, SettingsOf(false)), with(p, SettingsOf(false, true));
  EXPECT_FALSE(Refraction(p));
  const SpecularWeights weights = SpecularWeightsOf(p, SettingsOf(false, true));
  EXPECT_EQ(weights.transmitted, (R2::Color{}));
  EXPECT_NEAR(weights.reflected.r, 1, 1e-15);
  for (double choice = 0; choice < 1; choice += 0.01) {
    const auto lost = without.Sample({0.5, 0.5}, choice), kept = with.Sample({0.5, 0.5}, choice);
    EXPECT_TRUE(!lost || lost->lobe == Lobe::mirror);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->lobe, Lobe::mirror);
    EXPECT_NEAR(kept->wi.x, -0.8, 1e-15);
    EXPECT_NEAR(kept->wi.y, 0.6, 1e-15);
  }
}

TEST(Bsdf, TotalInternalReflectionWithoutFresnelIsOptional) {
  const Material glass = MaterialOf({}, {0.1, 0.1, 0.1}, {0.9, 0.8, 0.7});
  const ShadingPoint beyond = PointOf(glass, {0.8, 0.6, 0}, false), before = PointOf(glass, {0.6, 0.8, 0}, false);
  TraceSettings settings = SettingsOf(false);
  EXPECT_EQ(SpecularWeightsOf(beyond, settings).reflected, glass.kr);
  settings.internal_reflection = true;
  EXPECT_EQ(SpecularWeightsOf(beyond, settings).reflected, glass.kr + glass.kt);
  EXPECT_EQ(SpecularWeightsOf(beyond, settings).transmitted, (R2::Color{}));
  EXPECT_EQ(SpecularWeightsOf(before, settings).reflected, glass.kr);
  EXPECT_EQ(SpecularWeightsOf(before, settings).transmitted, glass.kt);
}

// Interpolated normals of coarse meshes face away, near silhouettes.
TEST(Bsdf, NormalsFacingAwayBendLightNoMoreThanGrazingOnes) {
  const double most = std::acos(1 / 1.5);
  for (const double ir : {1.0001, 1.5})
    for (double angle = 0; angle < 2; angle += 0.01) {
      const Material glass = MaterialOf({}, {}, {1, 1, 1}, 10, ir);
      ShadingPoint p = PointOf(glass, {1, 0, 0});
      p.N = {std::cos(angle), std::sin(angle), 0};
      const auto wi = Refraction(p);
      ASSERT_TRUE(wi) << angle;
      EXPECT_LE(std::acos(std::min(1.0, Dot(*wi, -p.wo))), (ir < 1.1 ? 0.0142 : most) + 1e-9) << ir << ' ' << angle;
    }
}

TEST(Bsdf, AnIndexOfOneLetsTheRayPassStraight) {
  const Material air = MaterialOf({}, {}, {1, 1, 1}, 10, 1);
  ShadingPoint p = PointOf(air, {0.6, 0.8, 0});
  p.time = 0.25;
  const auto sample = Bsdf(p, SettingsOf(false, true)).Sample({0.5, 0.5}, 0.5);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->wi, -p.wo);
  const R3::Ray ray = SpawnRay(p, sample->wi);
  EXPECT_EQ(ray.origin, p.free_point);
  EXPECT_EQ(ray.direction, -p.wo);
  EXPECT_EQ(ray.time, 0.25);
  const PathState next = Extend(p, sample->lobe, {0.5, 0.5, 0.5}, {});
  EXPECT_EQ(next.depth, 1);
  EXPECT_EQ(next.kind, RayKind::transmission);
}

TEST(Bsdf, FresnelSplitsTransmissionAndKeepsTheSum) {
  const Material m = MaterialOf({}, {0.1, 0.2, 0.3}, {0.8, 0.7, 0.6});
  for (const double aside : {0.0, 0.5, 0.9, 0.999}) {
    const double cosine = std::sqrt(1 - aside * aside);
    const ShadingPoint p = PointOf(m, {aside, cosine, 0});
    const SpecularWeights plain = SpecularWeightsOf(p, SettingsOf(false)),
                          split = SpecularWeightsOf(p, SettingsOf(false, true));
    EXPECT_EQ(plain.reflected, m.ks);
    EXPECT_EQ(plain.transmitted, m.kt);
    const double share = FresnelReflectance(cosine, 1 / 1.5);
    EXPECT_NEAR(split.reflected.r, 0.1 + share * 0.8, 1e-12);
    EXPECT_NEAR(split.reflected.g + split.transmitted.g, 0.9, 1e-15);
    EXPECT_NEAR(split.transmitted.b, (1 - share) * 0.6, 1e-12);
  }
}

TEST(FresnelReflectance, AtNormalIncidenceIsDifferenceOverSumSquared) {
  for (const double n : {1e-6, 0.5, 1 / 1.5, 1.0, 1.33, 1.5, 2.4, 1e6}) {
    const double amplitude = (1 - n) / (1 + n);
    EXPECT_NEAR(FresnelReflectance(1, 1 / n), amplitude * amplitude, 1e-14) << n;
    EXPECT_NEAR(FresnelReflectance(1, n), amplitude * amplitude, 1e-14) << n;
  }
}

TEST(Extremes, F9_GrazingLightIsAllReflected) {
  for (const double n : {0.1, 0.7, 1.000001, 1.5, 100.0}) {
    EXPECT_NEAR(FresnelReflectance(0, 1 / n), 1, 1e-12) << n;
    EXPECT_NEAR(FresnelReflectance(1e-300, 1 / n), 1, 1e-12) << n;
  }
}

// At Brewster's angle, whose tangent is n, light polarized in the plane of incidence is not reflected at all; the
// result is half of the reflectance for the other polarization: ((1 - n^2) / (1 + n^2))^2 / 2.
TEST(FresnelReflectance, AtBrewstersAngleIsOfOnePolarisationAlone) {
  for (const double n : {0.9, 1.33, 1.5, 2.4}) {
    const double across = (1 - n * n) / (1 + n * n);
    EXPECT_NEAR(FresnelReflectance(std::cos(std::atan(n)), 1 / n), across * across / 2, 1e-14) << n;
  }
}

TEST(Extremes, F4_ReflectanceReachesOneContinuouslyAtTheCriticalAngle) {
  const double n = 1.5, critical = std::sqrt(1 - 1 / (n * n));  // its cosine
  for (double cosine = 0; cosine < critical; cosine += 0.01) EXPECT_EQ(FresnelReflectance(cosine, n), 1) << cosine;
  double cosine = critical;
  for (int i = 0; i < 8; ++i) cosine = std::nextafter(cosine, 0.0);
  for (int i = 0; i < 16; ++i, cosine = std::nextafter(cosine, 1.0)) {
    const double share = FresnelReflectance(cosine, n);
    EXPECT_LE(share, 1);
    EXPECT_NEAR(share, 1, 1e-6);
  }
}

TEST(FresnelReflectance, IsASmoothShareAndTheSameFromBothSides) {
  for (const double n : {1.1, 1.5, 3.0}) {
    double last = 1;
    for (double cosine = 0; cosine <= 1; cosine += 0.001) {
      const double share = FresnelReflectance(cosine, 1 / n);
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      if (n <= 1.5 && cosine < 0.5) {
        EXPECT_LE(share, last) << "it falls from grazing on";
      }
      last = share;
      // Light along the reverse path is split in the same way: Stokes' relation.
      const double sine_behind = std::sqrt(1 - cosine * cosine) / n;
      EXPECT_NEAR(FresnelReflectance(std::sqrt(1 - sine_behind * sine_behind), n), share, 1e-9) << n << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace ray

// I1: in light that is 1 from everywhere, a thing that loses nothing cannot be seen.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "R3/ShapeKind.h"
#include "tests/BoundedShapes.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"
#include "tests/Named.h"
#include "tests/extremes/KnownScenes.h"

namespace statistics {
namespace {

using ray::RenderSettings;
using std::numbers::pi;

TEST(Extremes, I1_EveryShapeThatLosesNothingVanishesInAWhiteFurnace) {
  for (const R3::ShapeKind* kind : BoundedShapeKinds()) {
    std::string shape = std::string(kind->name) + " 0";
    for (const double x : kind->example) shape += " " + Words(x);
    const bool is_curved_inward = !crossings::IsConvex(*kind->make(kind->example));
    const struct {
      const char* name;
      std::string material;
      bool glossy, fresnel;
    } cases[] = {{"diffuse", Material(1, 0, 0, 0), false, false},
                 {"mirror", Material(0, 1, 0, 0), false, false},
                 {"half diffuse, half mirror", Material(0.5, 0.5, 0, 0), false, false},
                 {"glass by Fresnel", Material(0, 0, 1, 0, 10, 1.5), false, true},
                 {"dense glass by Fresnel", Material(0, 0, 1, 0, 10, 2.4), false, true},
                 {"thin glass by Fresnel", Material(0, 0, 1, 0, 10, 0.6), false, true},
                 {"part clear, part diffuse", Material(0.25, 0.25, 0.5, 0, 10, 1), false, true}};
    for (const auto& c : cases) {
      const project::Stage stage = StageOf(no_light + "background 1 1 1" + c.material + shape);
      RenderSettings settings = Path(16, 16);
      settings.trace.glossy = c.glossy;
      settings.trace.fresnel = c.fresnel;
      const auto image = project::Render(stage, settings).image;
      // Nothing is left to chance but the way, so every pixel is 1 within rounding, not only on average. Only within
      // glass that is not convex a path may circle, by total internal reflection, beyond any number of bounces: such a
      // sample is lost whole, and none but such may be.
      const bool may_circle = is_curved_inward && c.fresnel;
      for (const float channel : image.Channels()) {
        const double lost = may_circle ? std::round(16 * (1 - channel)) / 16 : 0;
        ASSERT_NEAR(channel + lost, 1, 1e-6) << kind->name << ", " << c.name;
      }
      EXPECT_GT(statistics::MeanOverPixels(image).mean, 1 - 1e-3) << kind->name << ", " << c.name;
    }
  }
}

TEST(Extremes, I1_AFurnaceThatIsAlsoALightIsAsWhite) {
  for (const double kd : {1.0, 0.5})
    for (const char* strategy : {"mis", "light", "bsdf", "uniform"}) {
      const project::Stage stage =
          StageOf(no_light + "camera 0 0 6 0 0 -1 0 1 0 0.1 0.01 100" + Material(kd, 1 - kd, 0, 0) + "sphere 0 0 0 0 1",
                  UniformSky(1));
      RenderSettings settings = Path(16, 256);
      settings.trace.strategy = project::Named{strategy};
      const Mean m = statistics::MeanOverPixels(project::Render(stage, settings).image);
      EXPECT_LT(std::abs(Deviations(m, 1, 1e-6)), 4) << strategy << ' ' << kd;
      EXPECT_NEAR(m.mean, 1, 1e-3) << strategy << ' ' << kd;
    }
}

TEST(Extremes, I1_MatteAndGlassBallsAreWhiteInModeWhitted) {
  const std::string camera = "camera 0 0 6 0 0 -1 0 1 0 0.1 0.01 100";
  RenderSettings settings = Whitted(32, 64);
  settings.trace.shadow_samples = 4;
  const Mean diffuse = statistics::MeanOverPixels(
      project::Render(StageOf(no_light + camera + Material(1, 0, 0, 0) + "sphere 0 0 0 0 1", UniformSky(1)), settings)
          .image);
  EXPECT_LT(std::abs(Deviations(diffuse, 1, 1e-6)), 4);
  EXPECT_NEAR(diffuse.mean, 1, 1e-3);
  for (const std::string coat : {"", "coat 0 1.3 "})
    for (const bool fresnel : {false, true}) {
      // Where each crossing splits the light, what is left in the glass after k bounces is below 0.2^k seen from afar.
      settings = Whitted(16, 1);
      settings.trace.max_depth = 12;
      settings.trace.fresnel = fresnel;
      const project::Stage stage =
          StageOf(no_light + camera + " background 1 1 1" + Material(0, 0, 1, 0, 10, 1.5) + coat + "sphere 0 0 0 0 1");
      const auto image = project::Render(stage, settings).image;
      for (const float channel : image.Channels()) EXPECT_NEAR(channel, 1, 1e-6) << coat << "fresnel " << fresnel;
    }
}

/// The share of Phong's lobe with exponent n, about a direction at an angle to the normal, that is above the surface:
/// at u = cos^(n+1) of the angle from the middle, which is even over the lobe, as many directions of the circle as
/// have cos(phi) > -cot cot.
double LobeAboveSurface(double n, double angle) {
  constexpr int steps = 200'000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = std::pow((i + 0.5) / steps, 1 / (n + 1)), sine = std::sqrt(1 - cosine * cosine);
    const double cotangents = cosine * std::cos(angle) / (sine * std::sin(angle));
    sum += cotangents >= 1 ? 1 : std::acos(-cotangents) / pi;
  }
  return sum / steps;
}

// The part of the lobe that points into the surface is lost by design; the rest is all there.
TEST(Extremes, I1_AGlossyPlaneKeepsTheLobeAboveIt) {
  for (const double n : {1.0, 10.0, 100.0, 1e4})
    for (const double angle : {0.0, 0.5, 1.2, 1.5})
      for (const char* mode : {"whitted", "path"}) {
        const std::string eye = Words(5 * std::sin(angle)) + " " + Words(5 * std::cos(angle)) + " 0 ";
        const std::string towards = Words(-std::sin(angle)) + " " + Words(-std::cos(angle)) + " 0 ";
        const project::Stage stage = StageOf(no_light + "background 1 1 1 camera " + eye + towards +
                                             "0 0 -1 1e-7 0.01 100" + Material(0, 1, 0, 0, n) + "box 0 -4 -1 -4 4 0 4");
        RenderSettings settings = Whitted(16, Count(256, 16384));
        settings.mode = project::Named{mode};
        settings.trace.glossy = true;
        const Mean m = statistics::MeanOverPixels(project::Render(stage, settings).image);
        const double truth = angle == 0 ? 1 : LobeAboveSurface(n, angle);
        EXPECT_LT(std::abs(Deviations(m, truth, 1e-5)), 4) << mode << " n " << n << " angle " << angle;
        EXPECT_NEAR(m.mean, truth, 1e-3) << mode << " n " << n << " angle " << angle;
      }
}

}  // namespace
}  // namespace statistics

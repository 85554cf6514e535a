// Pictures whose mean is known, or known to be that of another way to the same picture.

#include <gtest/gtest.h>

#include <numbers>

#include <charconv>
#include "R3/ShapeKind.h"
#include "source/film/PictureError.h"
#include "tests/BoundedShapes.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"
#include "tests/Named.h"
#include "tests/Statistics.h"

namespace {

using ray::RenderSettings;
using statistics::Compare;
using statistics::Comparison;
using statistics::Deviations;
using statistics::Mean;
using statistics::Pictures;

constexpr double pi = std::numbers::pi;

const std::string no_light = " point_light 0 0 0  0 9 0  1 0 0 ";  // keeps the default lights away

std::string Words(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// "material 0 0 0 ...", gray.
std::string Material(double kd, double ks, double kt, double emission, double n = 10, double ir = 1) {
  const auto gray = [](double x) { return Words(x) + " " + Words(x) + " " + Words(x) + "  "; };
  return " material 0 0 0  " + gray(kd) + gray(ks) + gray(kt) + gray(emission) + Words(n) + " " + Words(ir) + " 0 ";
}

R2::Image UniformSky(double light) {
  R2::Image image(16, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) image.Set(x, y, {light, light, light});
  return image;
}

/// Light 1 from less than `angle` from straight up, a whole number of eighths of a half turn.
R2::Image Cap(double angle) {
  R2::Image image = UniformSky(0);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x)
      if ((7.5 - y) * pi / 8 < angle) image.Set(x, y, {1, 1, 1});
  return image;
}

project::Stage StageOf(const std::string& text, const std::optional<R2::Image>& environment = {}) {
  ray::Scene scene = project::FromText(text);
  if (environment) scene.environment = std::make_shared<const ray::Environment>(*environment);
  return project::Stage(std::move(scene));
}

RenderSettings Path(int side, int samples) {
  RenderSettings s;
  s.width = s.height = side;
  s.samples = samples;
  s.mode = ray::RenderMode::path;
  s.trace.max_depth = 1000;
  return s;
}

RenderSettings Whitted(int side, int samples) {
  RenderSettings s = Path(side, samples);
  s.mode = ray::RenderMode::whitted;
  s.trace.min_luminance = 0;
  s.trace.shadow_samples = 1;
  return s;
}

// I1: in light that is 1 from everywhere, a thing that loses nothing cannot be seen.

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

TEST(Extremes, I1_TheCoursesModeIsWhiteOnAMatteBallAndInGlass) {
  const std::string camera = "camera 0 0 6 0 0 -1 0 1 0 0.1 0.01 100";
  RenderSettings settings = Whitted(32, 64);
  settings.trace.shadow_samples = 4;
  const Mean diffuse = statistics::MeanOverPixels(
      project::Render(StageOf(no_light + camera + Material(1, 0, 0, 0) + "sphere 0 0 0 0 1", UniformSky(1)), settings)
          .image);
  EXPECT_LT(std::abs(Deviations(diffuse, 1, 1e-6)), 4);
  EXPECT_NEAR(diffuse.mean, 1, 1e-3);
  for (const bool fresnel : {false, true}) {
    // Where each crossing splits the light, what is left in the glass after k bounces is below 0.2^k seen from afar.
    settings = Whitted(16, 1);
    settings.trace.max_depth = 12;
    settings.trace.fresnel = fresnel;
    const project::Stage stage =
        StageOf(no_light + camera + " background 1 1 1" + Material(0, 0, 1, 0, 10, 1.5) + "sphere 0 0 0 0 1");
    const auto image = project::Render(stage, settings).image;
    for (const float channel : image.Channels()) EXPECT_NEAR(channel, 1, 1e-6) << "fresnel " << fresnel;
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
TEST(Extremes, I1_AGlossyPlaneKeepsThePartOfItsLobeThatIsAboveIt) {
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

// I2 and I8: radiances that are known on paper.

struct Known {
  const char* name;
  std::string scene;
  double truth;
  RenderSettings settings;
  std::optional<R2::Image> environment{};
  double known_within = 1e-6;  // the pictures are a millionth wide, not a point
};

/// Light from a rectangle of radiance 1 that faces a point from right above one of its corners, over pi: the form
/// factor from the point to it. Sides a and b, height h.
///   source   Howell, A catalog of radiation heat transfer configuration factors, B-4
double FormFactorOfCorner(double a, double b, double h) {
  const double X = a / h, Y = b / h, x = std::sqrt(1 + X * X), y = std::sqrt(1 + Y * Y);
  return (X / x * std::atan(Y / x) + Y / y * std::atan(X / y)) / (2 * pi);
}

/// Two triangles.
std::string Square(int material, double half, double y) {
  const std::string m = "tri " + std::to_string(material) + " ", a = Words(half), b = Words(-half), h = Words(y);
  return m + b + " " + h + " " + b + "  " + a + " " + h + " " + b + "  " + a + " " + h + " " + a + " " + m + b + " " +
         h + " " + b + "  " + a + " " + h + " " + a + "  " + b + " " + h + " " + a + " ";
}

/// A closed cube of side 2 about the origin, of triangles, which light as well as they are seen.
std::string Get() {
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      const auto corner = [&](int i, int j) {
        std::array<int, 3> p{};
        p[static_cast<std::size_t>(axis)] = side;
        p[static_cast<std::size_t>((axis + 1) % 3)] = i;
        p[static_cast<std::size_t>((axis + 2) % 3)] = j;
        return std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "  ";
      };
      text += "tri 0 " + corner(-1, -1) + corner(1, -1) + corner(1, 1);
      text += "tri 0 " + corner(-1, -1) + corner(1, 1) + corner(-1, 1);
    }
  return text;
}

/// Sums p^k for k to `last`.
double Series(double p, int last) { return (1 - std::pow(p, last + 1)) / (1 - p); }

std::vector<Known> KnownScenes() {
  // All look at the origin, on a diffuse floor of kd 0.5 unless said otherwise, from the side and below what shines.
  const std::string camera = "camera 3 1 0  -3 -1 0  0 1 0  1e-7  0.01 100 ";
  const std::string floor = camera + Material(0.5, 0, 0, 0) + "box 0 -40 -1 -40 40 0 40 ";
  const int n = Count(64, 4096);
  const RenderSettings whitted = Whitted(16, n), path = Path(16, n);
  const auto with = [](RenderSettings settings, auto change) {
    change(settings.trace);
    return settings;
  };
  const auto depth = [&](RenderSettings settings, int most) {
    settings.trace.max_depth = most;
    return settings;
  };
  const double disc_without_falloff = 4 * std::log(1.25);  // (h/a)^2 ln(1 + (a/h)^2), a = 1, h = 2
  const double R = 0.04;                                   // glass of index 1.5 at right angles
  const std::string inside = "camera 0.1 0.2 0.3  0.3 0.1 -1  0 1 0  0.3  0.01 100 ";
  std::vector<Known> list{
      {"point light by the inverse square, 2 away", floor + "point_light 8 8 8  0 2 0  0 0 1", 0.5 * 8 / 4, whitted},
      {"point light by the inverse square, 8 away", floor + "point_light 8 8 8  0 8 0  0 0 1", 0.5 * 8 / 64, path},
      {"directional light by the cosine law at 60 degrees", floor + "dir_light 1 1 1  " + Words(std::sqrt(3)) + " -1 0",
       0.25, whitted},
      {"disc on its axis, without fall-off", floor + "area_light 1 1 1  0 2 0  0 -1 0  1  1 0 0",
       0.5 * disc_without_falloff, whitted},
      {"disc on its axis, by the inverse square", floor + "area_light 1 1 1  0 2 0  0 -1 0  1  0 0 1", 0.5 / (4 + 1),
       path},
      {"sphere light: that of a point in its middle", floor + "sphere_light 1 1 1  0 2 0  1.5  0 0 1", 0.5 / 4,
       whitted},
      {"sphere light from the side", floor + "sphere_light 1 1 1  3 4 0  2  0 0 1", 0.5 * 0.8 / 25, path},
      {"half of a disc behind a straight edge",
       floor + "area_light 1 1 1  0 2 0  0 -1 0  1  1 0 0 tri 0 0 1 -40  0 1 40  -40 1 0",
       0.5 * disc_without_falloff / 2, whitted},
      {"square on a floor, by its form factor", floor + no_light + Material(0, 0, 0, 1) + Square(1, 1, 1.5),
       0.5 * 4 * FormFactorOfCorner(1, 1, 1.5), depth(path, 0)},
      {"square on a floor, chosen places only", floor + no_light + Material(0, 0, 0, 1) + Square(1, 1, 1.5),
       0.5 * 4 * FormFactorOfCorner(1, 1, 1.5),
       with(depth(path, 0), [](auto& t) { t.strategy = ray::LightStrategy::light; })},
      {"square on a floor, scattered rays only", floor + no_light + Material(0, 0, 0, 1) + Square(1, 1, 1.5),
       0.5 * 4 * FormFactorOfCorner(1, 1, 1.5),
       with(depth(path, 0), [](auto& t) { t.strategy = ray::LightStrategy::bsdf; })},
      {"closed box that shines: E / (1 - p), with roulette", inside + no_light + Material(0.5, 0, 0, 1) + Get(),
       1 / (1 - 0.5), path},
      {"closed box that shines, half of it as a mirror does", inside + no_light + Material(0.25, 0.25, 0, 1) + Get(),
       1 / (1 - 0.5), path},
      {"closed box that shines, cut after two bounces", inside + no_light + Material(0.5, 0, 0, 1) + Get(),
       Series(0.5, 3), depth(path, 2)},  // the light of the last bounce's surroundings still counts
      {"lamp in the middle of a hollow ball: B / (1 - p)",
       inside + Material(0.6, 0, 0, 0) + "sphere 0 0 0 0 2 point_light 4 4 4  0 0 0  0 0 1", 0.6 / (1 - 0.6), path},
      {"lamp in a hollow ball, cut after three bounces",
       inside + Material(0.6, 0, 0, 0) + "sphere 0 0 0 0 2 point_light 4 4 4  0 0 0  0 0 1", 0.6 * Series(0.6, 3),
       depth(path, 3)},
      {"uniform sky over a plane", floor + no_light, 0.5, whitted, UniformSky(1)},
      {"uniform sky over a plane, path", floor + no_light, 0.5,
       with(path, [](auto& t) { t.strategy = ray::LightStrategy::light; }), UniformSky(1)},
      {"cap of 45 degrees of sky: half of what counts", floor + no_light, 0.25, whitted, Cap(pi / 4)},
      {"cap of 45 degrees of sky, path", floor + no_light, 0.25, path, Cap(pi / 4)},
      {"ambient light",
       floor.substr(0, camera.size()) + no_light + "ambient 0.4 0.4 0.4" +
           " material 0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  0 0 0  10 1 0 box 0 -40 -1 -40 40 0 40",
       0.2, path},
      {"slab that absorbs: exp(-a d), a way of 1.5 through it",
       "camera 0 0 5  0 0 -1  0 1 0  1e-7 0.01 100 background 1 1 1" + no_light + Material(0, 0, 1, 0) +
           "absorb 0 0.7 0.7 0.7 box 0 -9 -9 -1 9 9 0.5",
       std::exp(-0.7 * 1.5), whitted},
      {"five clear sheets: kt^5",
       "camera 0 5 0  0 -1 0  0 0 -1  1e-7 0.01 100 background 1 1 1" + no_light + Material(0, 0, 0.8, 0) +
           Square(0, 9, 0) + Square(0, 9, 1) + Square(0, 9, 2) + Square(0, 9, 3) + Square(0, 9, 4),
       std::pow(0.8, 5), with(path, [](auto& t) { t.roulette = ray::Roulette::off; })},
      {"pane of glass that reflects to and fro: 2 R / (1 + R)",
       "camera 0.3 5 0.4  0 -1 0  0 0 -1  1e-7 0.01 100" + no_light + Material(0, 0, 1, 0, 10, 1.5) +
           "box 0 -9 -1 -9 9 0 9",
       2 * R / (1 + R), with(path, [](auto& t) { t.fresnel = true; }), Cap(pi / 2)},
      {"pane of glass, each way followed",
       "camera 0.3 5 0.4  0 -1 0  0 0 -1  1e-7 0.01 100" + no_light + Material(0, 0, 1, 0, 10, 1.5) +
           "box 0 -9 -1 -9 9 0 9",
       2 * R / (1 + R), with(depth(whitted, 30), [](auto& t) { t.fresnel = true; }), Cap(pi / 2)},
  };
  return list;
}

/// What ten seeds gave of each known scene; made once for all tests that look at it.
const std::vector<std::vector<Mean>>& MeansOfKnownScenes() {
  static const std::vector<std::vector<Mean>> all = [] {
    std::vector<std::vector<Mean>> means;
    for (const Known& known : KnownScenes()) {
      const project::Stage stage = StageOf(known.scene, known.environment);
      RenderSettings settings = known.settings;
      means.emplace_back();
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        settings.seed = seed;
        settings.trace.sampler = static_cast<ray::SamplerKind>(seed % ray::sampler_names.size());
        means.back().push_back(statistics::MeanOverPixels(project::Render(stage, settings).image));
      }
    }
    return means;
  }();
  return all;
}

/// The rule of I2: each mean within 4 of its deviations of the truth, and their mean within 1.3.
bool IsTrue(const std::vector<Mean>& means, const Known& known, double factor) {
  double sum = 0, worst = 0;
  for (const Mean& mean : means) {
    const double deviations = Deviations(factor * mean, known.truth, known.known_within);
    sum += deviations;
    worst = std::max(worst, std::abs(deviations));
  }
  return worst <= 4 && std::abs(sum) <= 1.3 * static_cast<double>(means.size());
}

TEST(Extremes, I2_ScenesWithKnownRadianceHaveItOnAverage) {
  const auto scenes = KnownScenes();
  ASSERT_GE(scenes.size(), 12u);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto& means = MeansOfKnownScenes()[i];
    EXPECT_TRUE(IsTrue(means, scenes[i], 1)) << scenes[i].name;
    if (testing::Test::HasFailure() || std::getenv("RAYPRO_NIGHT"))
      for (const Mean& m : means)
        std::printf("%s: %.6f +- %.6f, truth %.6f, %.2f deviations off\n", scenes[i].name, m.mean, m.deviation,
                    scenes[i].truth, Deviations(m, scenes[i].truth, scenes[i].known_within));
  }
}

// The test of the test: what is half a percent too bright must be caught by nearly all of them.
TEST(Extremes, I8_ABiasOfHalfAPercentIsCaught) {
  const auto scenes = KnownScenes();
  for (const double factor : {1.005, 0.995}) {
    std::size_t caught = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const bool is_caught = !IsTrue(MeansOfKnownScenes()[i], scenes[i], factor);
      caught += is_caught;
      if (!is_caught) std::printf("%s would pass times %g\n", scenes[i].name, factor);
    }
    EXPECT_GE(4 * caught, 3 * scenes.size()) << "times " << factor;
  }
}

// I4: what more samples are worth.

/// The root mean square error against `truth` of pixels after each number of samples, over some seeds.
std::vector<double> ErrorsAfter(const std::vector<double>& counts, const char* sampler, double truth) {
  // Half of a disc light behind a straight edge: the edge jumps, and nothing else is to be learned.
  const project::Stage stage =
      StageOf("camera 3 1 0  -3 -1 0  0 1 0  1e-7  0.01 100" + Material(0.5, 0, 0, 0) +
              "box 0 -40 -1 -40 40 0 40 area_light 1 1 1  0 2 0  0 -1 0  1  1 0 0 tri 0 0 1 -40  0 1 40  -40 1 0");
  std::vector<double> errors;
  for (const double count : counts) {
    double squares = 0, pixels = 0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(Count(2, 4)); ++seed) {
      RenderSettings settings = Whitted(16, static_cast<int>(count));
      settings.seed = seed;
      settings.trace.sampler = project::Named{sampler};
      const auto image = project::Render(stage, settings).image;
      for (const float channel : image.Channels()) {
        squares += (channel - truth) * (channel - truth);
        ++pixels;
      }
    }
    errors.push_back(std::sqrt(squares / pixels));
  }
  return errors;
}

TEST(Extremes, I4_ErrorsFallAsTheRootOfTheSamplesOrFaster) {
  const double truth = 0.5 * 4 * std::log(1.25) / 2;
  std::vector<double> counts;
  for (double count = 16; count <= Count(4096, 65536); count *= 2) counts.push_back(count);
  for (const char* sampler : ray::sampler_names) {
    const auto errors = ErrorsAfter(counts, sampler, truth);
    const double slope = statistics::Slope(counts, errors);
    if (sampler == std::string("random")) {
      EXPECT_NEAR(slope, -0.5, 0.03);
    } else {
      EXPECT_LT(slope, -0.65) << sampler;  // a jump in two dimensions allows 3/4
    }
    std::printf("slope of %s: %.3f\n", sampler, slope);
  }
}

// I5 and I7: other ways to the same picture.

/// A floor, a wall and a ball, diffuse and glossy.
const std::string room =
    "camera 0 1.5 6  0 -0.2 -1  0 1 0  0.35  0.01 100" + Material(0.5, 0.3, 0, 0, 20) + Material(0.7, 0, 0, 0) +
    "tri 0 -9 0 -9  -9 0 9  9 0 9 tri 0 -9 0 -9  9 0 9  9 0 -9 tri 1 -9 0 -3  9 0 -3  0 12 -3 sphere 0 0.8 0.7 0 0.7 ";

std::string Lamps(bool shining_triangles) {
  std::string text =
      "point_light 3 2 1  -2 3 1  0 0 1 area_light 4 4 8  2 4 2  -1 -4 -2  0.7  0 0 1 "
      "sphere_light 1 3 1  -1 1 2  0.3  0 0 1 dir_light 0.1 0.1 0.2  1 -3 -1 "
      "spot_light 9 9 3  0 5 0  0 -1 0  0 0 1  0.5 3 ";
  if (shining_triangles)
    text += Material(0, 0, 0, 6) + "tri 2 -1.5 2 0  -1 2 0.5  -1.5 2.5 0.5 tri 2 1.5 2 0  2 2 0.5  1.5 2.5 0.5 ";
  return text;
}

/// A dim sky with a sun, lighter towards the horizon.
R2::Image SunnySky() {
  R2::Image image = UniformSky(0);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) image.Set(x, y, {0.3 + 0.02 * x, 0.4, 0.9 - 0.05 * y});
  for (const int y : {5, 6})
    for (const int x : {10, 11}) image.Set(x, y, {8, 7, 6});
  return image;
}

/// Whether pictures made with both settings have the same means, as far as can be seen: pixel by pixel and as a whole.
void ExpectSameMeans(const std::vector<R2::Image>& a, const std::vector<R2::Image>& b, const std::string& what) {
  const Comparison c = Compare(a, b);
  EXPECT_LE(c.worst_pixel, 1) << what;
  EXPECT_LE(std::abs(c.whole), 4) << what;
  EXPECT_LE(c.deviation, 0.01) << what << ": too noisy to tell anything";
}

constexpr int few = 20;  // pictures of each kind

RenderSettings Compared(const char* mode, int samples) {
  RenderSettings settings = Path(8, Count(samples, 64 * samples));
  settings.mode = project::Named{mode};
  settings.trace.max_depth = 3;
  settings.trace.min_luminance = 0;
  settings.trace.shadow_samples = 1;
  return settings;
}

/// Against the first of some settings; each with seeds of its own.
void ExpectAllAlike(const project::Stage& stage, const std::vector<std::pair<std::string, RenderSettings>>& settings) {
  const auto first = Pictures(stage, settings[0].second, few, 0);
  for (std::size_t i = 1; i < settings.size(); ++i)
    ExpectSameMeans(first, Pictures(stage, settings[i].second, few, 1000 * i),
                    settings[0].first + " and " + settings[i].first);
}

TEST(Extremes, I5_LightIsFoundAlikeOnLightsByScatteringAndByBoth) {
  for (const bool glossy : {false, true})
    for (const bool sky : {false, true}) {
      if (glossy == sky && !std::getenv("RAYPRO_NIGHT")) continue;
      const project::Stage stage =
          sky ? StageOf(room + no_light, SunnySky())
              : StageOf(room + no_light + Material(0, 0, 0, 5) + "tri 2 -3 2.5 0  1 3 0  -1 2.5 3 ");
      std::vector<std::pair<std::string, RenderSettings>> ways;
      for (const char* strategy : {"mis", "light", "bsdf", "uniform"}) {
        if (!sky && strategy == std::string("uniform")) continue;
        ways.emplace_back(strategy, Compared("path", 256));
        ways.back().second.trace.strategy = project::Named{strategy};
        ways.back().second.trace.glossy = glossy;
      }
      SCOPED_TRACE(std::string(sky ? "sky" : "triangle") + (glossy ? ", glossy" : ""));
      ExpectAllAlike(stage, ways);
    }
}

TEST(Extremes, I5_OneLightOrAFewStandForAll) {
  for (const char* mode : {"whitted", "path"}) {
    const project::Stage stage = StageOf(room + Lamps(true));
    std::vector<std::pair<std::string, RenderSettings>> ways;
    for (const int lights : {0, 1, 3}) {
      ways.emplace_back(std::to_string(lights) + " lights in " + mode, Compared(mode, 32));
      ways.back().second.trace.lights = lights;
    }
    ExpectAllAlike(stage, ways);
  }
}

TEST(Extremes, I5_TheCoursesModeAndPathsAgreeOnLightThatComesStraight) {
  // No mirrors, no bounces: both are the same integral over the sky and the lamps.
  std::string diffuse = room;
  const std::string glossy = Material(0.5, 0.3, 0, 0, 20);
  diffuse.replace(diffuse.find(glossy), glossy.size(), Material(0.5, 0, 0, 0));
  std::vector<std::pair<std::string, RenderSettings>> ways;
  for (const char* mode : {"whitted", "path"}) {
    ways.emplace_back(mode, Compared(mode, 64));
    ways.back().second.trace.max_depth = 0;
  }
  ExpectAllAlike(StageOf(diffuse + Lamps(false), SunnySky()), ways);
}

TEST(Extremes, I5_EverySamplerGivesTheSameMean) {
  for (const char* mode : {"whitted", "path"}) {
    std::vector<std::pair<std::string, RenderSettings>> ways;
    for (const char* sampler : ray::sampler_names) {
      if (std::string(sampler) == "grid") continue;  // its few places in a pixel are always the same
      ways.emplace_back(std::string(sampler) + " in " + mode, Compared(mode, 40));  // no square and no power of two
      ways.back().second.trace.sampler = project::Named{sampler};
      ways.back().second.trace.glossy = true;
      ways.back().second.camera = {.motion = {0.1, 0, 0}, .aperture = 0.05, .focus = 6};
    }
    ExpectAllAlike(StageOf(room + Lamps(true), SunnySky()), ways);
  }
}

TEST(Extremes, G5_StrataOfAnyNumberOfSamplesHaveTheRightMean) {
  const project::Stage stage =
      StageOf("camera 3 1 0  -3 -1 0  0 1 0  1e-7  0.01 100" + Material(0.5, 0, 0, 0) +
              "box 0 -40 -1 -40 40 0 40 area_light 1 1 1  0 2 0  0 -1 0  1  1 0 0 tri 0 0 1 -40  0 1 40  -40 1 0");
  const double truth = 0.5 * 4 * std::log(1.25) / 2;
  for (const char* mode : {"whitted", "path"})
    for (const int samples : {1, 2, 3, 5, 7, 13, 50}) {
      RenderSettings settings = Whitted(64, samples);
      settings.mode = project::Named{mode};
      settings.trace.max_depth = 0;
      settings.trace.sampler = ray::SamplerKind::stratified;
      const Mean m = statistics::MeanOverPixels(project::Render(stage, settings).image);
      EXPECT_LT(std::abs(Deviations(m, truth, 1e-6)), 4) << samples << " samples in " << mode;
      EXPECT_LT(m.deviation, 0.02 * truth) << samples << " samples in " << mode;
    }
}

TEST(Extremes, I7_RouletteCostsNoTruthAndPaysForItself) {
  // A hollow ball that keeps most of its light: without roulette every path is followed to the end.
  const project::Stage ball = StageOf("camera 0 0 1.9  0 0.3 -1  0 1 0  0.5  0.01 100" + Material(0.4, 0.1, 0, 0, 5) +
                                      "sphere 0 0 0 0 2 point_light 4 4 4  0 1 0  0 0 1");
  RenderSettings on = Compared("path", 32), off = on;
  on.trace.max_depth = off.trace.max_depth = 16;
  on.trace.roulette = ray::Roulette::on;
  off.trace.roulette = ray::Roulette::off;
  ExpectAllAlike(ball, {{"path, roulette", on}, {"none", off}});

  // What each ray is worth: variance times rays, in a room with many lamps.
  const project::Stage lamps = StageOf(room + Lamps(true));
  const auto cost = [&](RenderSettings settings) {
    settings.width = settings.height = 24;
    settings.trace.sampler = ray::SamplerKind::random;
    settings.samples = 16;
    const auto pictures = Pictures(lamps, settings, 8, 500);
    double variance = 0;
    for (int y = 0; y < settings.height; ++y)
      for (int x = 0; x < settings.width; ++x) {
        std::vector<double> values;
        for (const R2::Image& picture : pictures) values.push_back(Luminance(picture.At(x, y)));
        const double deviation = statistics::MeanOf(values).deviation;
        variance += deviation * deviation;
      }
    return variance * static_cast<double>(project::Render(lamps, settings).rays.Total());
  };
  std::printf("variance times rays: %g with roulette, %g without\n", cost(on), cost(off));
  EXPECT_LE(cost(on), cost(off));
}

TEST(Extremes, I7_TheCoursesModeMayFollowFaintMirrorsByChance) {
  // Mirrors that face each other, as in a dressing room.
  const std::string mirrors =
      "camera 0 0.1 0  0.1 0 -1  0 1 0  0.5  0.01 100" + Material(0.2, 0.6, 0, 0.1, 5) +
      "tri 0 -9 -9 -2  9 -9 -2  0 12 -2 tri 0 -9 -9 2  9 -9 2  0 12 2 point_light 1 1 1  0 1 0  0 0 1 "
      "background 0.5 0.5 0.5";
  RenderSettings exact = Compared("whitted", 8), by_chance = exact;
  exact.trace.max_depth = by_chance.trace.max_depth = 200;
  by_chance.trace.min_luminance = 0.3;
  by_chance.trace.roulette = ray::Roulette::on;
  const project::Stage stage = StageOf(mirrors);
  ExpectAllAlike(stage, {{"every ray", exact}, {"roulette", by_chance}});
  RenderSettings cut = by_chance;
  cut.trace.roulette = ray::Roulette::off;
  EXPECT_GT(std::abs(Compare(Pictures(stage, exact, few, 0), Pictures(stage, cut, few, 99)).whole), 4)
      << "cutting faint rays off loses light that this test should see";
  EXPECT_LT(project::Render(stage, by_chance).rays.Total(), project::Render(stage, exact).rays.Total());
}

// E6: lights without size.

TEST(Extremes, E6_LightsOfNoSizeGiveThePicturesOfPoints) {
  RenderSettings settings = Whitted(32, 2);
  const auto picture = [&](const std::string& light) { return project::Render(StageOf(room + light), settings).image; };
  // The order of roundings is that of a point light, so even the bits are.
  EXPECT_TRUE(picture("sphere_light 5 4 3  -1 3 1  0  0.1 0.2 0.3") ==
              picture("point_light 5 4 3  -1 3 1  0.1 0.2 0.3"));
  EXPECT_TRUE(picture("area_light 5 4 3  -1 3 1  0 -1 0  0  0.1 0.2 0.3") ==
              picture("spot_light 5 4 3  -1 3 1  0 -1 0  0.1 0.2 0.3  1.5707963267948966 1"));
  // And those of hardly any size give the same mean: where on them a sample goes still changes how much it brings.
  for (const std::string name : {"sphere_light 5 4 3  -1 3 1  ", "area_light 5 4 3  -1 3 1  0 -1 0  "}) {
    const auto pictures = [&](const std::string& size) {
      return Pictures(StageOf(room + name + size + "  0.1 0.2 0.3"), Compared("whitted", 64), few, 0);
    };
    ExpectSameMeans(pictures("0"), pictures("1e-7"), name);
  }
}

TEST(Extremes, E6_AFloorSeesNothingOfADiscEdgeOn) {
  const project::Stage stage = StageOf("camera 0 3 3  0 -1 -1  0 1 0  0.3  0.01 100" + Material(0.5, 0.3, 0, 0) +
                                       "box 0 -9 -1 -9  9 0 9 area_light 9 9 9  20 0 0  0 1 0  1  1 0 0");
  for (const char* mode : {"whitted", "path"}) {
    RenderSettings settings = Whitted(16, 16);
    settings.mode = project::Named{mode};
    const auto image = project::Render(stage, settings).image;
    for (const float channel : image.Channels()) EXPECT_EQ(channel, 0) << mode;
  }
}

// The width of a soft shadow: behind a straight edge at half the height of a disc of radius 1, the floor goes from all
// of the disc to none of it over the disc's own width, and sees half of it in the middle.
TEST(Extremes, I2_ASoftShadowIsAsWideAsGeometrySays) {
  const auto at = [](double x) {
    const project::Stage stage =
        StageOf("camera " + Words(x + 3) + " 0.5 0  -3 -0.5 0  0 1 0  1e-7  0.01 100" + Material(0.5, 0, 0, 0) +
                "box 0 -40 -1 -40 40 0 40 area_light 1 1 1  0 2 0  0 -1 0  1  1 0 0 tri 0 0 1 -400  0 1 400  -400 1 0");
    return statistics::MeanOverPixels(project::Render(stage, Whitted(8, 256)).image).mean;
  };
  // Without fall-off the light itself varies; what is compared is the share of it.
  const auto without = [](double x) {
    const project::Stage stage =
        StageOf("camera " + Words(x + 3) + " 0.5 0  -3 -0.5 0  0 1 0  1e-7  0.01 100" + Material(0.5, 0, 0, 0) +
                "box 0 -40 -1 -40 40 0 40 area_light 1 1 1  0 2 0  0 -1 0  1  1 0 0");
    return statistics::MeanOverPixels(project::Render(stage, Whitted(8, 256)).image).mean;
  };
  EXPECT_EQ(at(-1.01), 0);
  EXPECT_GT(at(-0.95), 0);
  EXPECT_NEAR(at(0) / without(0), 0.5, 2e-3);
  EXPECT_LT(at(0.95) / without(0.95), 0.9999);
  EXPECT_EQ(at(1.01), without(1.01));
  for (double x = -0.9; x < 0.9; x += 0.2) EXPECT_LT(at(x), at(x + 0.2)) << x;
}

}  // namespace

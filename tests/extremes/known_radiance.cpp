// I2 and I8: radiances that are known on paper.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/Draw.h"
#include "tests/extremes/KnownScenes.h"

namespace statistics {
namespace {

using ray::RenderSettings;
using std::numbers::pi;

/// Light 1 from less than `angle` from straight up, a whole number of eighths of a half turn.
R2::Image Cap(double angle) {
  R2::Image image = UniformSky(0);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x)
      if ((7.5 - y) * pi / 8 < angle) image.Set(x, y, {1, 1, 1});
  return image;
}

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
std::string ClosedCube() {
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
      {"closed box that shines: E / (1 - p), with roulette", inside + no_light + Material(0.5, 0, 0, 1) + ClosedCube(),
       1 / (1 - 0.5), path},
      {"closed box that shines, half of it as a mirror does",
       inside + no_light + Material(0.25, 0.25, 0, 1) + ClosedCube(), 1 / (1 - 0.5), path},
      {"closed box that shines, cut after two bounces", inside + no_light + Material(0.5, 0, 0, 1) + ClosedCube(),
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
}  // namespace statistics

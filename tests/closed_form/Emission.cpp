// Light from shapes that emit, in mode path: closed forms, and integrals over their surfaces that share no code with
// the program.

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "R3/Matrix.h"
#include "tests/Named.h"
#include "tests/Statistics.h"

namespace {

using statistics::Deviations;
using statistics::Mean;

constexpr const char* strategies[] = {"mis", "light", "bsdf", "uniform"};

/// Gray, the second with emission 3, the third doing both.
const std::string materials =
    "point_light 0 0 0  0 9 0  1 0 0 "
    "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  10 1 0 material 0 0 0  0 0 0  0 0 0  0 0 0  3 3 3  10 1 0 "
    "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  1 1 1  10 1 0 ";
constexpr double kd = 0.5, emission = 3;

ray::RenderSettings PathSettings(const char* strategy = "mis") {
  ray::RenderSettings s;
  s.width = s.height = 16;
  s.samples = 64;
  s.mode = ray::RenderMode::path;
  s.trace.max_depth = 0;
  s.trace.strategy = project::Named{strategy};
  return s;
}

Mean Shown(const std::string& scene, const ray::RenderSettings& settings) {
  const project::Stage stage(project::FromText(scene));
  return statistics::MeanOverPixels(project::Render(stage, settings).image);
}

/// What is seen of the middle of a floor, its normal up, at the origin.
const std::string floor_seen =
    "camera 0.3 0.4 0  -3 -4 0  0 0 -1  1e-7  0.01 100 " + materials + "box 0  -4 -1 -4  4 0 4 ";

void ExpectMean(const Mean& m, double truth, double known_within, const std::string& what) {
  EXPECT_LT(std::abs(Deviations(m, truth, known_within)), 4) << what << ": " << m.mean << ", not " << truth;
  EXPECT_LT(m.deviation, 0.05 * truth) << what << ": too noisy to tell";
}

/// The light of a sphere that is wholly above the floor: E = pi L (r / d)^2 cos.
double FloorUnderSphere(const R3::Point& center, double radius) {
  const double d = Length(FromOrigin(center));
  return kd * emission * radius * radius / (d * d) * (center.y / d);
}

TEST(Emission, TheInsideOfAnEmissiveSolidShowsAllBounces) {
  // e + kd e + kd^2 e + ... = 1 / (1 - 0.5).
  for (const char* shape : {"sphere 2  0 0 0  1", "box 2  -1 -1 -1  1 1 1", "cylinder 2  0 0 0  1 2",
                            "cone 2  0 0 -0.3  2 4", "torus 2  0 0 0  4 3.9"})
    for (const char* strategy : {"mis", "bsdf"}) {
      ray::RenderSettings settings = PathSettings(strategy);
      settings.trace.max_depth = 60;
      const Mean m = Shown("camera 0.1 0.2 0.3  0.3 0.1 -1  0 1 0  0.3  0.01 100 " + materials + shape, settings);
      ExpectMean(m, 2, 1e-6, std::string(shape) + ", " + strategy);
    }
}

TEST(Emission, AnEmissiveSphereLightsAFloorAsLambertSays) {
  for (const char* strategy : strategies) {
    ExpectMean(Shown(floor_seen + "sphere 1  1 2 0.5  0.8", PathSettings(strategy)), FloorUnderSphere({1, 2, 0.5}, 0.8),
               1e-6, strategy);
    for (const int at_once : {0, 1, 3}) {
      ray::RenderSettings settings = PathSettings(strategy);
      settings.trace.lights = at_once;
      ExpectMean(Shown(floor_seen + "sphere 1  1 2 0.5  0.8 sphere 1  -2 3 0  1", settings),
                 FloorUnderSphere({1, 2, 0.5}, 0.8) + FloorUnderSphere({-2, 3, 0}, 1), 1e-6,
                 std::string(strategy) + ", two lamps, at once " + std::to_string(at_once));
    }
  }
}

TEST(Emission, OneShapeInTwoGroupsIsTwoLamps) {
  ray::Scene scene = project::FromText(floor_seen +
                                       "begin -1  1 0 0 1  0 1 0 2  0 0 1 0.5  0 0 0 1 sphere 1  0 0 0  0.8 end "
                                       "begin -1  1 0 0 -2  0 1 0 3  0 0 1 0  0 0 0 1 sphere 1  0 0 0  0.8 end");
  auto& groups = scene.root.children;
  groups.back().children[0].shape = groups[groups.size() - 2].children[0].shape;
  const project::Stage stage(std::move(scene));
  for (const char* strategy : strategies)
    ExpectMean(statistics::MeanOverPixels(project::Render(stage, PathSettings(strategy)).image),
               FloorUnderSphere({1, 2, 0.5}, 0.8) + FloorUnderSphere({-2, 3, 0}, 0.8), 1e-6, strategy);
}

TEST(Emission, TinyAndHugeSpheresLightLikeAnyOther) {
  const std::string tiny = "material 0 0 0  0 0 0  0 0 0  0 0 0  3e12 3e12 3e12  10 1 0 sphere 3  1 2 0.5  1e-6";
  ExpectMean(Shown(floor_seen + tiny, PathSettings()), FloorUnderSphere({1, 2, 0.5}, 1), 1e-6, "tiny");
  for (const char* strategy : strategies)
    ExpectMean(Shown(floor_seen + "sphere 1  0 1000001 0  1000000", PathSettings(strategy)),
               FloorUnderSphere({0, 1000001, 0}, 1e6), 1e-6, strategy);
}

using Patch = std::function<R3::Point(double, double)>;

/// The faces of shapes, each over the unit square.
std::vector<Patch> Sphere(double r) {
  return {[=](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = std::numbers::pi * v;
    return R3::Point{r * std::sin(b) * std::cos(a), r * std::cos(b), r * std::sin(b) * std::sin(a)};
  }};
}
std::vector<Patch> Turned(double low_radius, double high_radius, double half_height) {
  const auto at = [](double radius, double u, double y) {
    const double a = 2 * std::numbers::pi * u;
    return R3::Point{radius * std::cos(a), y, radius * std::sin(a)};
  };
  return {[=](double u, double v) { return at(std::lerp(low_radius, high_radius, v), u, half_height * (2 * v - 1)); },
          [=](double u, double v) { return at(v * low_radius, u, -half_height); },
          [=](double u, double v) { return at(v * high_radius, u, half_height); }};
}
std::vector<Patch> Cuboid(double x, double y, double z) {
  std::vector<Patch> faces;
  for (const double side : {-1.0, 1.0}) {
    faces.emplace_back([=](double u, double v) { return R3::Point{side * x, y * (2 * u - 1), z * (2 * v - 1)}; });
    faces.emplace_back([=](double u, double v) { return R3::Point{x * (2 * u - 1), side * y, z * (2 * v - 1)}; });
    faces.emplace_back([=](double u, double v) { return R3::Point{x * (2 * u - 1), y * (2 * v - 1), side * z}; });
  }
  return faces;
}

/// What the floor shows of a convex solid all above it: each direction into it crosses its faces twice, so the integral
/// over all faces is twice that over what is seen.
double FloorUnder(const std::vector<Patch>& faces, const R3::Matrix& outer, const R3::Matrix& inner = {}) {
  constexpr int n = 300;
  double sum = 0;
  for (const Patch& face : faces)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto at = [&](double u, double v) { return outer * (inner * face((i + u) / n, (j + v) / n)); };
        const R3::Vector area = 0.5 * Cross(at(1, 1) - at(0, 0), at(0, 1) - at(1, 0)), way = FromOrigin(at(0.5, 0.5));
        const double d = Length(way);
        sum += std::abs(Dot(area, way)) / (d * d * d) * std::max(0.0, way.y / d);
      }
  return kd * emission / std::numbers::pi * sum / 2;
}

struct Solid {
  std::string line;
  std::vector<Patch> faces;
};

std::vector<Solid> ConvexSolids() {
  return {{"sphere 1  0 0 0  0.7", Sphere(0.7)},
          {"box 1  -0.5 -0.4 -0.3  0.5 0.4 0.3", Cuboid(0.5, 0.4, 0.3)},
          {"box 1  -0.5 0 -0.3  0.5 0 0.3", Cuboid(0.5, 0, 0.3)},
          {"cylinder 1  0 0 0  0.5 1.2", Turned(0.5, 0.5, 0.6)},
          {"cone 1  0 0 0  0.6 1.2", Turned(0.6, 0, 0.6)}};
}

TEST(Emission, EverySolidLightsAFloorAsItsSurfaceIntegralSays) {
  const R3::Matrix above{{{{1, 0, 0, 0.8}, {0, 1, 0, 1.5}, {0, 0, 1, -0.6}}}};
  for (const Solid& solid : ConvexSolids())
    for (const char* strategy : strategies)
      ExpectMean(Shown(floor_seen + "begin -1  1 0 0 0.8  0 1 0 1.5  0 0 1 -0.6  0 0 0 1 " + solid.line + " end",
                       PathSettings(strategy)),
                 FloorUnder(solid.faces, above), 1e-3, solid.line + ", " + strategy);
}

TEST(Emission, SoDoSolidsThatNestedGroupsStretchAndShear) {
  const R3::Matrix outer{{{{1, 0.7, 0, 0.2}, {0, 1, 0, 1.8}, {0, 0.2, 1, 0.5}}}},
      inner{{{{0.8, 0, 0.3, 0}, {0, 1.5, 0, 0}, {0.6, 0, -0.4, 0.1}}}};
  for (const Solid& solid : ConvexSolids())
    for (const char* strategy : strategies)
      ExpectMean(Shown(floor_seen +
                           "begin -1  1 0.7 0 0.2  0 1 0 1.8  0 0.2 1 0.5  0 0 0 1 "
                           "begin -1  0.8 0 0.3 0  0 1.5 0 0  0.6 0 -0.4 0.1  0 0 0 1 " +
                           solid.line + " end end",
                       PathSettings(strategy)),
                 FloorUnder(solid.faces, outer, inner), 1e-3, solid.line + ", " + strategy);
}

TEST(Emission, ATorusLightsAlikeByEveryStrategy) {
  const std::string scene = floor_seen + "torus 1  0.5 1.5 0  1 0.3";
  const Mean by_bsdf = Shown(scene, PathSettings("bsdf"));
  for (const char* strategy : {"mis", "light", "uniform"}) {
    const Mean m = Shown(scene, PathSettings(strategy));
    EXPECT_LT(std::abs(m.mean - by_bsdf.mean), 4 * std::hypot(m.deviation, by_bsdf.deviation)) << strategy;
    EXPECT_LT(std::hypot(m.deviation, by_bsdf.deviation), 0.01 * m.mean) << strategy;
  }
}

TEST(Emission, AMovingLampLightsByTheMeanOverTheShutter) {
  double truth = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) truth += FloorUnderSphere({1 - 2 * (i + 0.5) / steps, 2, 0.5}, 0.8) / steps;
  for (const char* strategy : strategies)
    ExpectMean(
        Shown(floor_seen + "begin -1  1 0 0 1  0 1 0 2  0 0 1 0.5  0 0 0 1 motion -2 0 0 sphere 1  0 0 0  0.8 end",
              PathSettings(strategy)),
        truth, 1e-5, strategy);
}

TEST(Emission, AMeshLightsLikeTheSphereItApproximates) {
  constexpr int columns = 32, rows = 16;
  const Patch face = Sphere(0.8)[0];
  std::string mesh;
  const auto corner = [&](int column, int row) {
    const R3::Point p = face(1.0 * column / columns, 1.0 * row / rows) + R3::Vector{1, 2, 0.5};
    return "  " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
  };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      if (j > 0) mesh += "tri 1" + corner(i, j) + corner(i + 1, j) + corner(i, j + 1) + "\n";
      if (j < rows - 1) mesh += "tri 1" + corner(i + 1, j) + corner(i + 1, j + 1) + corner(i, j + 1) + "\n";
    }
  // Between corners the mesh lies as much as 1 - cos(pi / 16), 2 %, below the sphere.
  ExpectMean(Shown(floor_seen + mesh, PathSettings()), FloorUnderSphere({1, 2, 0.5}, 0.8), 0.01, "mesh");
}

TEST(Emission, AConvexLampDoesNotLightItsOwnOutside) {
  for (const char* shape :
       {"sphere 2  0 0 0  1", "box 2  -1 -1 -1  1 1 1", "cylinder 2  0 0 0  1 2", "cone 2  0 0 0  1 2"})
    for (const char* strategy : strategies) {
      ray::RenderSettings settings = PathSettings(strategy);
      settings.trace.max_depth = 3;
      const Mean m = Shown("camera 2 1 4  -2 -1 -4  0 1 0  0.05  0.01 100 " + materials + shape, settings);
      EXPECT_NEAR(m.mean, 1, 1e-6) << shape << ", " << strategy;
    }
}

TEST(Emission, TouchingLampsLightEachOtherAlikeByEveryStrategy) {
  // Seen 3 degrees beside the place where they touch.
  const std::string scene =
      "camera 1 5 0  -0.00137 -4.94766 0  0 0 1  1e-6  0.01 100 " + materials + "sphere 2  0 0 0  1 sphere 2  2 0 0  1";
  ray::RenderSettings settings = PathSettings("bsdf");
  settings.trace.max_depth = 2;
  const Mean by_bsdf = Shown(scene, settings);
  EXPECT_GT(by_bsdf.mean, 1.2);
  for (const char* strategy : {"mis", "light", "uniform"}) {
    settings.trace.strategy = project::Named{strategy};
    const Mean m = Shown(scene, settings);
    EXPECT_LT(std::abs(m.mean - by_bsdf.mean), 4 * std::hypot(m.deviation, by_bsdf.deviation)) << strategy;
    EXPECT_LT(std::hypot(m.deviation, by_bsdf.deviation), 0.01 * m.mean) << strategy;
  }
}

TEST(Emission, AFloorUnderAnInfiniteLampShowsAlbedoTimesEmission) {
  for (const char* strategy : strategies)
    EXPECT_NEAR(Shown(floor_seen + "plane 1  0 3 0  0 -1 0", PathSettings(strategy)).mean, kd * emission, 1e-6)
        << strategy;
}

/// A sphere that cannot be sampled.
class Opaque : public R3::Shape {
 public:
  explicit Opaque(std::shared_ptr<const R3::Shape> shape) : shape_(std::move(shape)) {}
  R3::Box Bounds(int element) const override { return shape_->Bounds(element); }
  std::optional<R3::Hit> Intersect(const R3::Ray& ray, int element) const override {
    return shape_->Intersect(ray, element);
  }
  R3::Intersection At(const R3::Ray& ray, const R3::Hit& hit, int element) const override {
    return shape_->At(ray, hit, element);
  }

 private:
  std::shared_ptr<const R3::Shape> shape_;
};

TEST(Emission, LampsThatCannotBeSampledCountInFull) {
  for (const char* strategy : strategies) {
    ray::Scene scene = project::FromText(floor_seen + "sphere 1  1 2 0.5  0.8");
    auto& shape = scene.root.children.back().shape;
    shape = std::make_shared<Opaque>(shape);
    const project::Stage stage(std::move(scene));
    ExpectMean(statistics::MeanOverPixels(project::Render(stage, PathSettings(strategy)).image),
               FloorUnderSphere({1, 2, 0.5}, 0.8), 1e-6, strategy);
  }
}

TEST(Emission, SolidsLightInModeWhittedOnlyOnRequest) {
  // Each point of the lamp shines like a point light of its emission without fall-off.
  ray::RenderSettings settings = PathSettings();
  settings.mode = ray::RenderMode::whitted;
  for (const int lights : {-1, 1}) {
    settings.trace.lights = lights;
    for (const char* shape : {"sphere 1  0 2 0  1e-4", "box 1  -1e-4 2 -1e-4  1e-4 2.0001 1e-4",
                              "cylinder 1  0 2 0  1e-4 1e-4", "torus 1  0 2 0  1e-4 4e-5"}) {
      settings.trace.emissive_solids_light = true;
      EXPECT_NEAR(Shown(floor_seen + shape, settings).mean, kd * emission, 1e-6) << shape << ", lights " << lights;
      settings.trace.emissive_solids_light = false;
      EXPECT_EQ(Shown(floor_seen + shape, settings).mean, 0) << shape;
    }
  }
}

// The settings of a picture in mode path whose lamps shine as in mode whitted.
ray::RenderSettings ColorSettings(const char* strategy, int lights) {
  ray::RenderSettings settings = PathSettings(strategy);
  settings.trace.emission = ray::Emission::color;
  settings.trace.emissive_solids_light = true;
  settings.trace.lights = lights;
  return settings;
}

TEST(Emission, OfAColorIsIndependentOfSizeAndDistance) {
  for (const char* strategy : {"mis", "bsdf"})
    for (const int lights : {0, 1})
      for (const std::string shape : {"sphere 1  0 2 0  1e-4", "box 1  -1e-4 2 -1e-4  1e-4 2.0001 1e-4",
                                      "torus 1  0 2 0  1e-4 4e-5", "tri 1  0 2 0  1e-4 2 0  0 2 1e-4",
                                      "quad 1  0 9 0  1e-4 9 0  1e-4 9 1e-4  0 9 1e-4"}) {
        const ray::RenderSettings settings = ColorSettings(strategy, lights);
        const std::string what = shape + ", " + strategy + ", " + std::to_string(lights) + " at once";
        EXPECT_NEAR(Shown(floor_seen + shape, settings).mean, kd * emission, 1e-6) << what;
        // Straight above the floor again, so that the one is in the other's shadow.
        ExpectMean(Shown(floor_seen + shape + " sphere 1  3 4 0  1e-4", settings), kd * emission * (1 + 0.8), 1e-6,
                   what + ", and another");
      }
}

TEST(Emission, OfAColorIsCountedOnceDespiteScatteredRays) {
  // The mean cosine over a cone of directions with a half angle a is (1 + cos a) / 2.
  const double cosine = std::sqrt(1 - 0.8 * 0.8 / 4);
  for (const char* strategy : strategies)
    for (const std::int64_t depth : {0, 3}) {
      ray::RenderSettings settings = ColorSettings(strategy, 0);
      settings.trace.max_depth = depth;
      ExpectMean(Shown(floor_seen + "sphere 1  0 2 0  0.8", settings), kd * emission * (1 + cosine) / 2, 1e-6,
                 strategy);
    }
}

TEST(Emission, OfAColorIsReflectedFromWallToWall) {
  // In a hollow sphere every wall sends kd e straight from the middle, and kd of what all others send.
  for (const char* strategy : {"mis", "bsdf"}) {
    ray::RenderSettings settings = ColorSettings(strategy, 0);
    settings.trace.max_depth = 60;
    ExpectMean(Shown("camera 0.1 0.2 0.3  0.3 0.1 -1  0 1 0  0.3  0.01 100 " + materials +
                         "sphere 0  0 0 0  1 sphere 1  0 0 0  1e-3",
                     settings),
               kd * emission / (1 - kd), 1e-3, strategy);
  }
}

TEST(Emission, OfAColorIsShownByMirrorsAndThroughGlass) {
  const std::string mirror = "material 0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  10 1 0 mirror 3  0.5 0.5 0.5 ",
                    glass = "material 0 0 0  0 0 0  0 0 0  0.5 0.5 0.5  0 0 0  10 1 0 ";
  ray::RenderSettings settings = ColorSettings("mis", 0);
  settings.trace.max_depth = 2;
  for (const std::string& material : {mirror, glass}) {
    const std::string lamp = material == mirror ? "sphere 1  0 0 9  3 " : "sphere 1  0 0 -9  3 ";
    const std::string scene = "camera 0 0 5  0 0 -1  0 1 0  0.01  0.01 100 " + materials + material + lamp;
    EXPECT_NEAR(Shown(scene + "quad 3  -1 -1 0  1 -1 0  1 1 0  -1 1 0", settings).mean, 0.5 * emission, 1e-6)
        << material;
  }
}

TEST(Emission, OfAColorSkipsBlurredMirrorsBeyondTheLastBounce) {
  const std::string scene =
      "camera 0 0 5  0 0 -1  0 1 0  0.01  0.01 100 background 0.1 0.1 0.1 " + materials +
      "material 0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  1 1 0 mirror 3  0.5 0.5 0.5 gloss 3  50 1 "
      "quad 3  -1 -1 0  1 -1 0  1 1 0  -1 1 0 sphere 1  0 0 20  14 ";
  ray::RenderSettings settings = ColorSettings("mis", 0);
  EXPECT_LE(Shown(scene, settings).mean, 0.5 * 0.1) << "the lamp fills the lobe";
  settings.trace.max_depth = 1;
  EXPECT_GT(Shown(scene, settings).mean, 0.4 * emission);
}

TEST(Emission, OfAColorDoesNotLightTheLampItself) {
  for (const char* shape :
       {"sphere 2  0 0 0  1", "torus 2  0 0 0  1.5 0.5", "quad 2  -1 -1 0  1 -1 0.1  1 1 0  -1 1 0.1"})
    for (const int lights : {0, 1}) {
      const ray::RenderSettings settings = ColorSettings("mis", lights);
      const Mean m = Shown("camera 2 1 4  -2 -1 -4  0 1 0  0.05  0.01 100 " + materials + shape, settings);
      EXPECT_NEAR(m.mean, 1, 1e-6) << shape << ", " << lights << " at once";
    }
}

// One of everything, so that each light has its own number: lamps come between lights and the environment.
TEST(Emission, OfAColorMakesBothModesAgreeOnDirectLight) {
  const std::string scene = floor_seen + "dir_light 1 1 1  0 -1 0 environment " +
                            (project::Root() / "scenes/textures/sky.hdr").string() +
                            " tri 1  1 2 0  2 2 0  1 2 1 quad 1  -2 3 0  -1 3 0  -1 3 2  -2 3 1 sphere 1  0 2 1  0.3 "
                            "torus 1  -1 2 -1  0.3 0.1 box 1  1 1 -1  1.5 1.5 -0.5";
  for (const bool solids : {false, true}) {
    ray::RenderSettings settings = ColorSettings("mis", 0);
    settings.trace.emissive_solids_light = solids;
    ray::RenderSettings whitted = settings;
    whitted.mode = ray::RenderMode::whitted;
    const Mean truth = Shown(scene, whitted);
    for (const int lights : {0, 1}) {
      settings.trace.lights = lights;
      const Mean m = Shown(scene, settings);
      const double deviation = std::hypot(m.deviation, truth.deviation);
      EXPECT_LT(std::abs(m.mean - truth.mean), 4 * deviation) << solids << ", " << lights << " at once";
      EXPECT_LT(deviation, 0.01 * truth.mean) << "too noisy to tell";
    }
  }
}

}  // namespace

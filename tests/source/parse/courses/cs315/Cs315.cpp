#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

const std::string camera = "'camera': {'eye': [0, 0, 5], 'at': [0, 0, 0], 'up': [0, 1, 0], 'fovy': 45, 'aspect': 1}";

/// Returns a scene with a camera; single quotes stand for double ones.
ParsedScene Cs315(const std::string& keys, const std::string& view = camera) {
  std::string json = "{" + view + (keys.empty() ? "" : ", ") + keys + "}";
  std::replace(json.begin(), json.end(), '\'', '"');
  const Folder folder;
  return Parse(folder.Write("scene.json", json), {});
}

ParsedScene WithSurface(const std::string& surface, const std::string& material = "{'kd': [1, 1, 1]}") {
  return Cs315("'materials': [" + material + "], 'surfaces': [" + surface + "]");
}

std::optional<double> Depth(const Scene& scene, const R3::Ray& ray) {
  const World world(scene);
  Workspace workspace;
  const auto hit = FindAcceleratorKind("none")->Make(world, {})->Intersect(ray, workspace);
  return hit ? std::optional(hit->t) : std::nullopt;
}

std::string ValueOf(const Scene& scene, const std::string& option) {
  for (const SceneSetting& setting : scene.settings)
    if (setting.option == option) return setting.value;
  return "(none)";
}

// The values that the assignment prints for rays of a 512 x 512 image, where a ray goes through a pixel's corner.
TEST(Cs315, RaysAreThoseOfTheAssignment) {
  const Scene scene = Cs315("").scene;
  const double w = 2 * std::tan(22.5 * std::numbers::pi / 180);
  const auto through = [&](double i, double j) {
    // Pixel (i, j) is counted from the top, and the last one's corner is at the right and lower edge.
    const R3::Vector d = scene.camera.Through(i * 512 / 511, 512 - j * 512 / 511, 512, 512).direction;
    return R3::Vector{d.x / -d.z, d.y / -d.z, -1};
  };
  EXPECT_NEAR(through(0, 0).x, -w / 2, 1e-12);
  EXPECT_NEAR(through(0, 0).x, -0.41421356, 1e-8);
  EXPECT_NEAR(through(0, 0).y, 0.41421356, 1e-8);
  EXPECT_NEAR(through(512, 512).x, 0.41583475, 1e-8);
  EXPECT_NEAR(through(512, 512).y, -0.41583475, 1e-8);
  EXPECT_NEAR(through(256, 256).x, 0.00081059, 1e-8);
  EXPECT_NEAR(through(256, 256).y, -0.00081059, 1e-8);
}

TEST(Cs315, AspectWidensTheImageForAnyPixels) {
  const Scene scene =
      Cs315("", "'camera': {'eye': [0, 0, 5], 'at': [0, 0, 0], 'up': [0, 1, 0], 'fovy': 90, 'aspect': 1.5}").scene;
  for (const int width : {512, 100}) {
    const R3::Vector corner = scene.camera.Through(width, 512, width, 512).direction;
    EXPECT_NEAR(corner.x / -corner.z, 1.5, 1e-12);
    EXPECT_NEAR(corner.y / -corner.z, 1, 1e-12);
  }
}

TEST(Cs315, TheCoursesRulesAreSettings) {
  const Scene plain = Cs315("").scene;
  for (const auto& [option, value] : {std::pair{"width", "512"},
                                      {"height", "512"},
                                      {"samples", "1"},
                                      {"sampler", "grid"},
                                      {"bytes", "truncated"},
                                      {"max_depth", "0"},
                                      {"clamp", "(none)"}})
    EXPECT_EQ(ValueOf(plain, option), value) << option;
  EXPECT_EQ(plain.shadow_bias, 0.0001);
  const Scene told = Cs315("'bounce_depth': 5, 'shadow_bias': 0.005").scene;
  EXPECT_EQ(ValueOf(told, "max_depth"), "5");
  EXPECT_EQ(told.shadow_bias, 0.005);
}

TEST(Cs315, SurfacesMoveWhileTheShutterIsOpen) {
  const Scene scene = WithSurface(
                          "{'shape': 'Sphere', 'center': [0, 0, 0], 'radius': 1, 'material': 0, "
                          "'velocity': [3, 0, 0]}")
                          .scene;
  EXPECT_EQ(Depth(scene, {.origin = {0, 0, 5}, .direction = {0, 0, -1}, .time = 0}), 4);
  EXPECT_EQ(Depth(scene, {.origin = {0, 0, 5}, .direction = {0, 0, -1}, .time = 1}), std::nullopt);
  EXPECT_EQ(Depth(scene, {.origin = {3, 0, 5}, .direction = {0, 0, -1}, .time = 1}), 4);
}

TEST(Cs315, TheCamerasExposureTimeScalesTheirMotion) {
  const auto way_in = [](const std::string& time) {
    std::string view = camera;
    view.insert(view.size() - 1, ", 'exposureTime': " + time);
    const Scene scene = Cs315(
                            "'materials': [{}], 'surfaces': [{'shape': 'Sphere', 'center': [0, 0, 0], 'radius': 1, "
                            "'material': 0, 'velocity': [3, 0, -1]}]",
                            view)
                            .scene;
    return scene.root.children.at(0).motion;
  };
  EXPECT_EQ(way_in("1"), (R3::Vector{3, 0, -1}));
  EXPECT_EQ(way_in("0.5"), (R3::Vector{1.5, 0, -0.5}));
  EXPECT_EQ(way_in("0"), (R3::Vector{}));
  EXPECT_ANY_THROW(way_in("-1"));
}

// An independent interpolation by barycentric coordinates, from either side.
TEST(Cs315, NormalsOfATrianglesCornersAreBlended) {
  for (const auto& [a, b, c] : {std::array{"'n0'", "'n1'", "'n2'"}, {"'n1'", "'n2'", "'n3'"}}) {
    const std::string normals = ", " + std::string(a) + ": [-2, 0, 2], " + b + ": [1, 0, 1], " + c + ": [0, 1, 1]";
    const ParsedScene parsed = WithSurface(
        "{'shape': 'Triangle', 'p1': [0, 0, 0], 'p2': [3, 0, 0], 'p3': [0, 3, 0], 'material': 0" + normals + "}");
    EXPECT_TRUE(parsed.warnings.empty()) << parsed.warnings.front();
    const World world(parsed.scene);
    Workspace workspace;
    const auto accelerator = FindAcceleratorKind("none")->Make(world, {});
    for (const double z : {5, -5}) {
      const R3::Ray ray{.origin = {0.6, 1.5, z}, .direction = {0, 0, -z}};
      const auto hit = accelerator->Intersect(ray, workspace);
      ASSERT_TRUE(hit);
      const double h = std::numbers::sqrt2 / 2, u = 0.2, v = 0.5, w = 1 - u - v;
      const R3::Vector blend = w * R3::Vector{-h, 0, h} + u * R3::Vector{h, 0, h} + v * R3::Vector{0, h, h};
      const auto n = world.At(ray, *hit).shading_normal;
      EXPECT_NEAR(std::abs(Dot(Unit(blend), R3::Vector{n.x, n.y, n.z})), 1, 1e-12) << a << " " << z;
    }
  }
}

TEST(Cs315, ATriangleHasAllNormalsOrNone) {
  EXPECT_ANY_THROW(
      WithSurface("{'shape': 'Triangle', 'p1': [0, 0, 0], 'p2': [3, 0, 0], 'p3': [0, 3, 0], "
                  "'material': 0, 'n0': [0, 0, 1], 'n1': [0, 0, 1]}"));
}

TEST(Cs315, AFocalDepthAtTheTopCountsAsTheCameras) {
  EXPECT_EQ(ValueOf(Cs315("'focal_depth': 7").scene, "focus"), "7");
}

TEST(Cs315, LightsOfAllKindsAddUp) {
  const Scene scene =
      Cs315(
          "'lights': [{'source': 'Ambient', 'color': [0.25, 0, 0]}, {'source': 'Ambient', 'color': [0.5, 1, 0]}, "
          "{'source': 'Point', 'position': [0, 5, 0], 'color': [1, 1, 1]}, "
          "{'source': 'Directional', 'direction': [0, -2, 0], 'color': [0.5, 0.5, 1]}]")
          .scene;
  EXPECT_EQ(scene.ambient, (R2::Color{0.75, 1, 0}));
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0]->Illuminate({0, -5, 0}, {})->irradiance, (R2::Color{1, 1, 1}));
  const auto sun = scene.lights[1]->Illuminate({0, -5, 0}, {});
  EXPECT_TRUE(sun->is_infinite);
  EXPECT_EQ(Unit(sun->to_light), (R3::Vector{0, 1, 0})) << "the direction is that of travel";
  EXPECT_TRUE(Cs315("").scene.lights.empty()) << "no default lights";
}

TEST(Cs315, KrWeighsMirrorsAndZeroShininessDropsHighlights) {
  const Scene scene = Cs315(
                          "'materials': [{'ka': [1, 0, 0], 'kd': [0, 1, 0], 'ks': [0.5, 0.5, 0.5], 'shininess': 0, "
                          "'kr': [0, 0, 0.75]}, "
                          "{'ks': [1, 1, 1], 'shininess': 30, 'gloss': 50, 'gloss_samples': 4}]")
                          .scene;
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[1].ka, (R2::Color{1, 0, 0}));
  EXPECT_EQ(scene.materials[1].kd, (R2::Color{0, 1, 0}));
  EXPECT_EQ(scene.materials[1].ks, (R2::Color{0, 0, 0}));
  EXPECT_EQ(scene.materials[1].kr, (R2::Color{0, 0, 0.75}));
  EXPECT_EQ(scene.materials[2].ks, (R2::Color{1, 1, 1}));
  EXPECT_EQ(scene.materials[2].n, 30);
  EXPECT_EQ(scene.materials[2].gloss, 50);
  EXPECT_EQ(scene.materials[2].gloss_samples, 4);
  EXPECT_EQ(scene.materials[1].gloss, 0);
  EXPECT_EQ(scene.materials[2].kr, (R2::Color{0, 0, 0})) << "missing";
  EXPECT_EQ(scene.materials[2].kd, (R2::Color{0, 0, 0})) << "missing";
}

TEST(Cs315, TheLastTransformActsFirst) {
  const std::string ball = "{'shape': 'Sphere', 'center': [1, 0, 0], 'radius': 1, 'material': 0, 'transforms': ";
  // The ball from 0 to 2 is stretched to 0..6, then moved to 10..16.
  const Scene moved = WithSurface(ball + "[['Translate', [10, 0, 0]], ['Scale', [3, 1, 1]]]}").scene;
  EXPECT_NEAR(*Depth(moved, {{0, 0, 0}, {1, 0, 0}}), 10, 1e-12);
  // Moved to 10..12 first, it would be stretched to 30..36.
  const Scene stretched = WithSurface(ball + "[['Scale', [3, 1, 1]], ['Translate', [10, 0, 0]]]}").scene;
  EXPECT_NEAR(*Depth(stretched, {{0, 0, 0}, {1, 0, 0}}), 30, 1e-12);
}

TEST(Cs315, ARotationAboutZActsFirstCounterClockwise) {
  const std::string ball = "{'shape': 'Sphere', 'center': [5, 0, 0], 'radius': 1, 'material': 0, 'transforms': ";
  const Scene scene = WithSurface(ball + "[['Rotate', [90, 0, 90]]]}").scene;  // +x to +y, and that to +z
  EXPECT_NEAR(*Depth(scene, {{0, 0, 0}, {0, 0, 1}}), 4, 1e-12);
  EXPECT_FALSE(Depth(scene, {{0, 0, 0}, {0, 1, 0}}));
}

TEST(Cs315, ATriangleIsSeenFromBothSides) {
  for (const char* corners : {"'p1': [-1, -1, 0], 'p2': [1, -1, 0], 'p3': [0, 1, 0]",
                              "'p1': [-1, -1, 0], 'p2': [0, 1, 0], 'p3': [1, -1, 0]"}) {
    const Scene scene = WithSurface("{'shape': 'Triangle', " + std::string(corners) + ", 'material': 0}").scene;
    EXPECT_TRUE(Depth(scene, {{0, 0, 5}, {0, 0, -1}}));
  }
}

TEST(Cs315, OurOwnShapesAreInLowerCase) {
  const Scene scene =
      WithSurface("{'shape': 'torus', 'position': [0, 0, 0], 'radius': 2, 'tube': 0.5, 'material': 0}").scene;
  EXPECT_NEAR(*Depth(scene, {{2, 0, 9}, {0, 0, -1}}), 8.5, 1e-9);
  const Scene blob = WithSurface("{'shape': 'blob', 'threshold': 0.125, 'material': 0, "
                                 "'balls': [{'position': [0, 0, 0], 'radius': 3}]}")
                         .scene;
  EXPECT_NEAR(*Depth(blob, {{0, 0, 9}, {0, 0, -1}}), 9 - 3 * std::sqrt(0.5), 1e-9);
}

TEST(JsonScenes, AreDistinguishedByTheirTopLevelKeys) {
  const Folder folder;
  EXPECT_EQ(Parse(folder.Write("a.json", "{\"Eye\": [0, 0, 9], \"Objects\": []}"), {}).scene.settings.front().origin,
            "Groningen");
  std::string cs = "{" + camera + "}";
  std::replace(cs.begin(), cs.end(), '\'', '"');
  EXPECT_EQ(Parse(folder.Write("b.json", cs), {}).scene.settings.front().origin, "CS 315");
  ParseOptions options;
  options.format = "cs315";
  EXPECT_TRUE(Contains(
      [&] {
        try {
          Parse(folder / "a.json", options);
          return std::string();
        } catch (const SceneErrors& errors) {
          return std::string(errors.what());
        }
      }(),
      "the scene lacks camera"))
      << "the user's word counts";
}

TEST(JsonScenes, AnUnknownFormatIsReportedWithTheKnownOnes) {
  const Folder folder;
  folder.Write("a.json", "{}");
  ParseOptions options;
  options.format = "groninge";
  EXPECT_EQ(ReportOf(folder, "a.json", options),
            "a.json: error: unknown scene format 'groninge'; did you mean 'groningen'?");
}

}  // namespace
}  // namespace ray

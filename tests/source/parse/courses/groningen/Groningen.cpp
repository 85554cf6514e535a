#include <gtest/gtest.h>

#include <filesystem>
#include <cmath>
#include <numbers>

#include "R3/Mesh.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

/// Returns a scene in the JSON form, which every build reads, next to the files of a folder; single quotes stand for
/// double ones.
ParsedScene Groningen(std::string json, const Folder& folder = {}) {
  std::replace(json.begin(), json.end(), '\'', '"');
  ParseOptions options;
  options.format = "groningen";
  return Parse(folder.Write("scene.json", json), options);
}

const std::string red_ball =
    "{'type': 'sphere', 'position': [0, 0, 0], 'radius': 1, 'material': "
    "{'color': [1, 0, 0.5], 'ka': 0.2, 'kd': 0.7, 'ks': 0.5, 'n': 64}}";

ParsedScene WithKeys(const std::string& keys, const std::string& objects = red_ball) {
  return Groningen("{'Eye': [200, 200, 1000], 'Objects': [" + objects + "]" + (keys.empty() ? "" : ", ") + keys + "}");
}

std::string SettingOf(const Scene& scene, const std::string& option) {
  for (const SceneSetting& setting : scene.settings)
    if (setting.option == option) return setting.value;
  return "(none)";
}

/// Returns the position and the normal of a ray's first hit.
struct Met {
  double t = 0;
  R3::Intersection at;
};
std::optional<Met> Trace(const Scene& scene, const R3::Ray& ray) {
  const World world(scene);
  const auto accelerator = FindAcceleratorKind("none")->Make(world, {});
  Workspace workspace;
  const auto hit = accelerator->Intersect(ray, workspace);
  if (!hit) return {};
  return Met{hit->t, world.At(ray, *hit)};
}

TEST(Groningen, TheEyeFormMapsUnitsAtZ0ToPixels) {
  const Scene scene = Groningen("{'Eye': [150, 260, 700], 'Objects': []}").scene;
  EXPECT_EQ(SettingOf(scene, "width"), "400");
  EXPECT_EQ(SettingOf(scene, "height"), "400");
  for (const auto& [x, y] : {std::pair{0.5, 0.5}, {399.5, 0.5}, {17.5, 301.5}}) {
    const R3::Ray ray = scene.camera.Through(x, y, 400, 400);
    const R3::Point p = ray.At(-ray.origin.z / ray.direction.z);
    EXPECT_NEAR(p.x, x, 1e-9);
    EXPECT_NEAR(p.y, y, 1e-9);
  }
}

TEST(Groningen, CamerasAimAtTheirCenterAndUpSizesPixels) {
  const Scene scene =
      Groningen(
          "{'Camera': {'eye': [1, 2, 30], 'center': [4, 5, 6], 'up': [0, 0.75, 0], 'viewSize': [800, 400]}, "
          "'Objects': []}")
          .scene;
  EXPECT_EQ(SettingOf(scene, "width"), "800");
  EXPECT_EQ(SettingOf(scene, "height"), "400");
  const R3::Vector towards = R3::Unit(R3::Point{4, 5, 6} - R3::Point{1, 2, 30});
  const auto in_plane = [&](double x, double y) {
    const R3::Ray ray = scene.camera.Through(x, y, 800, 400);
    return ray.At(Dot(R3::Point{4, 5, 6} - ray.origin, towards) / Dot(ray.direction, towards));
  };
  EXPECT_NEAR(Length(in_plane(400, 200) - R3::Point{4, 5, 6}), 0, 1e-12);
  EXPECT_NEAR(Length(in_plane(401, 200) - in_plane(400, 200)), 0.75, 1e-12);
  EXPECT_NEAR(Length(in_plane(400, 201) - in_plane(400, 200)), 0.75, 1e-12);
}

TEST(Groningen, ACameraDirectionMeansACenter1000Away) {
  const Scene given =
      Groningen("{'Camera': {'position': [1, 2, 3], 'direction': [0, 0, -2], 'up': [0, 1, 0]}, 'Objects': []}").scene;
  const Scene wanted =
      Groningen("{'Camera': {'eye': [1, 2, 3], 'center': [1, 2, -997], 'up': [0, 1, 0]}, 'Objects': []}").scene;
  EXPECT_EQ(given.camera.eye, wanted.camera.eye);
  EXPECT_EQ(given.camera.towards, wanted.camera.towards);
  EXPECT_EQ(given.camera.xfov, wanted.camera.xfov);
}

TEST(Groningen, ACameraReplacesAnEye) {
  const Scene scene =
      Groningen("{'Eye': [1, 1, 1], 'Camera': {'eye': [0, 0, 9], 'center': [0, 0, 0]}, 'Objects': []}").scene;
  EXPECT_EQ(scene.camera.eye, (R3::Point{0, 0, 9}));
}

TEST(Groningen, TheCoursesRulesAreSettingsThatTheFileOverrides) {
  const Scene plain = WithKeys("").scene;
  for (const auto& [option, value] : {std::pair{"samples", "1"},
                                      {"sampler", "grid"},
                                      {"max_depth", "0"},
                                      {"shadows", "off"},
                                      {"clamp", "samples"},
                                      {"bytes", "truncated"},
                                      {"min_luminance", "0"},
                                      {"internal_reflection", "on"},
                                      {"mode", "(none)"},
                                      {"zbuffer_range", "(none)"}})
    EXPECT_EQ(SettingOf(plain, option), value) << option;
  for (const SceneSetting& setting : plain.settings) EXPECT_EQ(setting.origin, "Groningen") << setting.option;

  const Scene scene = WithKeys(
                          "'Shadows': 'yes', 'MaxRecursionDepth': 2, 'SuperSampling': {'factor': 4}, "
                          "'RenderMode': 'ZBuffer', 'ZBuffer': {'near': 500, 'far': 900.5}")
                          .scene;
  for (const auto& [option, value] : {std::pair{"samples", "16"},
                                      {"max_depth", "2"},
                                      {"shadows", "on"},
                                      {"mode", "zbuffer"},
                                      {"zbuffer_range", "500 900.5"}})
    EXPECT_EQ(SettingOf(scene, option), value) << option;
  const auto depth = std::find_if(scene.settings.begin(), scene.settings.end(),
                                  [](const SceneSetting& setting) { return setting.option == "max_depth"; });
  EXPECT_TRUE(depth->origin.ends_with("scene.json:1")) << depth->origin;
}

TEST(Groningen, EverySpellingOfSuperSamplingIsTaken) {
  for (const char* keys :
       {"'SuperSampling': {'factor': 3}", "'SuperSampling': 3", "'SuperSamplingFactor': 3", "'AntiAliasing': 3"})
    EXPECT_EQ(SettingOf(WithKeys(keys).scene, "samples"), "9") << keys;
  for (const char* word : {"true", "'yes'", "'On'"})
    EXPECT_EQ(SettingOf(WithKeys(std::string("'AntiAliasing': ") + word).scene, "samples"), "4") << word;
  EXPECT_EQ(SettingOf(WithKeys("'AntiAliasing': false").scene, "samples"), "1");
  EXPECT_EQ(SettingOf(WithKeys("'AntiAliasing': 1").scene, "samples"), "1") << "a number is a factor";
  EXPECT_EQ(SettingOf(WithKeys("'SuperSampling': {'factor': 2, 'pattern': 'jitter'}").scene, "sampler"), "stratified");
  EXPECT_EQ(SettingOf(WithKeys("'SuperSampling': {'factor': 2, 'pattern': 'rotated'}").scene, "sampler"),
            "rotated_grid");
  const ParsedScene adaptive = WithKeys("'SuperSampling': {'factor': 2, 'pattern': 'adaptive'}");
  EXPECT_EQ(SettingOf(adaptive.scene, "sampler"), "grid");
  EXPECT_EQ(SettingOf(adaptive.scene, "adaptive"), "neighbors");
  EXPECT_TRUE(adaptive.warnings.empty());
  EXPECT_EQ(SettingOf(WithKeys("'SuperSampling': {'factor': 2, 'pattern': 'poisson'}").scene, "sampler"), "poisson");
}

TEST(Groningen, EveryRenderModeAndItsNumberIsTaken) {
  for (const auto& [word, mode] : {std::pair{"'phong'", "whitted"},
                                   {"'Normal'", "normal_color"},
                                   {"1", "zbuffer"},
                                   {"0", "whitted"},
                                   {"2", "normal_color"},
                                   {"3", "gooch"},
                                   {"'textureCoordinate'", "uv_color"},
                                   {"'texcoord'", "uv_color"},
                                   {"'toon'", "toon"},
                                   {"'flat'", "flat"}})
    EXPECT_EQ(SettingOf(WithKeys("'RenderMode': " + std::string(word)).scene, "mode"), mode) << word;
  EXPECT_EQ(SettingOf(WithKeys("'RenderMode': 'gooch'").scene, "gooch"), "0.55 0.3 0.25 0.5");
  EXPECT_EQ(SettingOf(WithKeys("'GoochParameters': {'b': 1, 'beta': 0}").scene, "gooch"), "1 0.3 0.25 0");
  EXPECT_EQ(SettingOf(WithKeys("'RenderMode': 'gooch'").scene, "outline"), "(none)") << "as in the course's image";
  for (const auto& [asked, width] : {std::pair{"true", "2"}, {"false", "0"}, {"'yes'", "2"}, {"1.5", "1.5"}})
    EXPECT_EQ(SettingOf(WithKeys("'GoochParameters': {'outline': " + std::string(asked) + "}").scene, "outline"), width)
        << asked;
  EXPECT_EQ(SettingOf(WithKeys("'RenderMode': 'phongg'").scene, "mode"), "(none)");
}

TEST(Groningen, ALensIsFocusedOnTheCentersPlane) {
  const std::string camera =
      "{'Objects': [], 'SuperSampling': 2, 'Camera': {'eye': [0, 0, 9], 'center': [0, 0, 2], "
      "'apertureRadius': 0.5, 'apertureSamples': 16";
  const Scene scene = Groningen(camera + "}}").scene;
  for (const auto& [option, value] :
       {std::pair{"aperture", "0.5"}, {"focus", "7"}, {"lens", "spiral"}, {"lens_samples", "16"}, {"samples", "64"}})
    EXPECT_EQ(SettingOf(scene, option), value) << option;
  EXPECT_EQ(SettingOf(Groningen(camera + ", 'apertureJitter': false}}").scene, "lens"), "fixed_spiral");
}

TEST(Groningen, MovingObjectsAreInPlaceAtMidExposure) {
  std::string moving = red_ball;
  moving.insert(moving.size() - 1, ", 'velocity': [10, 0, 0]");
  const std::string still = "{'Camera': {'eye': [0, 0, 9], 'center': [0, 0, 0]}, 'Objects': [" + moving + "]}";
  EXPECT_TRUE(Trace(Groningen(still).scene, {{0, 0, 9}, {0, 0, -1}}));
  const Scene scene = Groningen(
                          "{'Camera': {'eye': [0, 0, 9], 'center': [0, 0, 0], 'exposureTime': 0.5, "
                          "'exposureSamples': 4}, 'Objects': [" +
                          moving + "]}")
                          .scene;
  EXPECT_EQ(SettingOf(scene, "samples"), "4");
  EXPECT_EQ(SettingOf(scene, "shutter_samples"), "4");
  EXPECT_EQ(SettingOf(scene, "motion"), "(none)");
  const auto is_hit = [&](double x, double time) {
    R3::Ray ray{{x, 0, 9}, {0, 0, -1}};
    ray.time = time;
    return Trace(scene, ray).has_value();
  };
  EXPECT_TRUE(is_hit(0, 0.5));
  EXPECT_TRUE(is_hit(-2.5, 0));
  EXPECT_FALSE(is_hit(0, 0));
  EXPECT_TRUE(is_hit(2.5, 1));
}

TEST(Groningen, OneSampleExposuresAreSharpAtTheirMiddle) {
  std::string moving = red_ball;
  moving.insert(moving.size() - 1, ", 'velocity': [10, 0, 0]");
  for (const char* samples : {"", ", 'exposureSamples': 1"}) {
    const Scene scene = Groningen(
                            "{'Camera': {'eye': [0, 0, 9], 'center': [0, 0, 0], 'velocity': [8, 0, 0], 'exposureTime': "
                            "0.5" +
                            std::string(samples) + "}, 'Objects': [" + moving + "]}")
                            .scene;
    EXPECT_EQ(SettingOf(scene, "motion"), "(none)");
    EXPECT_EQ(scene.camera.eye.x, 0);
    for (const double time : {0.0, 0.5, 1.0}) {
      R3::Ray ray{{0, 0, 9}, {0, 0, -1}};
      ray.time = time;
      EXPECT_TRUE(Trace(scene, ray)) << time;
    }
  }
}

TEST(Groningen, MovingCamerasAreInPlaceAtMidExposure) {
  const auto moving = [](const std::string& time) {
    return Groningen("{'Camera': {'eye': [0, 0, 9], 'center': [0, 0, 0], 'velocity': [8, 0, -2], 'exposureTime': " +
                     time + ", 'exposureSamples': 4}, 'SuperSampling': 3, 'Objects': []}")
        .scene;
  };
  const Scene scene = moving("0.5");
  EXPECT_EQ(SettingOf(scene, "motion"), "4 0 -1");
  EXPECT_EQ(SettingOf(scene, "samples"), "36");
  EXPECT_EQ(scene.camera.eye, (R3::Point{-2, 0, 9.5}));
  const Scene still = moving("0");
  EXPECT_EQ(SettingOf(still, "motion"), "(none)");
  EXPECT_EQ(SettingOf(still, "samples"), "9");
  EXPECT_EQ(still.camera.eye, (R3::Point{0, 0, 9}));
}

TEST(Groningen, AMaterialIsGrayCoefficientsTimesItsColor) {
  const Scene scene = WithKeys("").scene;
  const Material& m = scene.materials.back();
  const auto is = [](const R2::Color& a, const R2::Color& b) { return Luminance(a - b) < 1e-15 && a.r - b.r < 1e-15; };
  EXPECT_TRUE(is(m.ka, {0.2, 0, 0.1}));
  EXPECT_TRUE(is(m.kd, {0.7, 0, 0.35}));
  EXPECT_EQ(m.ks, (R2::Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(m.kr, (R2::Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(m.n, 64);
  EXPECT_EQ(m.color, (R2::Color{1, 0, 0.5}));
}

TEST(Groningen, LongNamesAndGlassAreTaken) {
  const Scene scene =
      WithKeys("",
               "{'type': 'sphere', 'position': [0, 0, 0], 'radius': 1, 'texture': 'none', 'normals': 'none', "
               "'material': {'color': [1, 1, 1], 'ambient': 0.1, 'diffuse': 0.2, 'specular': 0.3, "
               "'shininess': 4, 'kt': 0.5, 'refractive_index': 0, 'gloss': 90, 'glossSamples': 8}}")
          .scene;
  const Material& m = scene.materials.back();
  EXPECT_EQ(m.ka.r, 0.1);
  EXPECT_EQ(m.kd.r, 0.2);
  EXPECT_EQ(m.ks.r, 0.3);
  EXPECT_EQ(m.n, 4);
  EXPECT_EQ(m.kt.r, 0.5);
  EXPECT_EQ(m.gloss, 90);
  EXPECT_EQ(m.gloss_samples, 8);
  EXPECT_FALSE(m.normal_map);
  EXPECT_EQ(m.ir, 1) << "0 means none";
  EXPECT_FALSE(m.texture);
}

TEST(Groningen, ASpecularMapMultipliesKs) {
  const auto maps = [](const std::string& name) {
    return WithKeys("",
                    "{'type': 'sphere', 'position': [0, 0, 0], 'radius': 1, 'material': {'color': [1, 1, 1], 'ka': 0, "
                    "'kd': 0, 'ks': 1, 'n': 1, 'specularMap': '" +
                        name + "'}}");
  };
  const std::string image = std::filesystem::absolute(project::Root() / "scenes/textures/checker.png").string();
  const Material m = maps(image).scene.materials.back();
  ASSERT_TRUE(m.specular_map);
  EXPECT_EQ(m.specular_map->image.Width(), m.specular_map->image.Height());
  EXPECT_FALSE(maps("none").scene.materials.back().specular_map);
}

TEST(Groningen, AmbientLightIsTheSumOfTheLights) {
  const Scene scene = WithKeys(
                          "'Lights': [{'position': [0, 0, 9], 'color': [0.5, 1.5, 0]}, "
                          "{'position': [0, 9, 9], 'color': [0.25, 0, 1]}]")
                          .scene;
  EXPECT_EQ(scene.ambient, (R2::Color{0.75, 1.5, 1}));
  ASSERT_EQ(scene.lights.size(), 2u);
  const auto sample = scene.lights[0]->Illuminate({0, 0, 0}, {});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->irradiance, (R2::Color{0.5, 1.5, 0})) << "no weaker with distance";
  EXPECT_TRUE(WithKeys("").scene.lights.empty()) << "no default lights";
}

// An extension: the course has point lights only.
TEST(Groningen, ALightMayBeOfAnyKind) {
  const Scene scene =
      WithKeys(
          "'Lights': [{'type': 'directional', 'direction': [0, -1, 0], 'color': [1, 0, 0]}, "
          "{'type': 'spot', 'position': [0, 9, 0], 'direction': [0, -1, 0], 'sc': 0.5, 'sd': 2, 'color': [1, 1, 0]}, "
          "{'type': 'area', 'position': [0, 9, 0], 'direction': [0, -1, 0], 'radius': 1, 'color': [1, 1, 1]}, "
          "{'type': 'sphere', 'position': [0, 9, 0], 'radius': 1, 'qa': 0.5, 'color': [0, 0, 1]}]")
          .scene;
  ASSERT_EQ(scene.lights.size(), 4u);
  for (const auto& light : scene.lights) EXPECT_TRUE(light->Illuminate({0, 0, 0}, {0.5, 0.5})) << light->Describe();
  EXPECT_EQ(scene.ambient, (R2::Color{3, 2, 2}));
}

/// Returns the texture coordinates of a sphere of radius 2 about 1 2 3 at a point seen from outside along -n.
R2::Point TexturePlace(const std::string& keys, const R3::Vector& n) {
  const Scene scene = WithKeys("'RenderMode': 'texcoord'", "{'type': 'sphere', 'position': [1, 2, 3], " + keys +
                                                               ", 'material': {'color': [1, 1, 1]}}")
                          .scene;
  const auto met = Trace(scene, {R3::Point{1, 2, 3} + 9 * n, -n});
  return met ? met->at.uv : R2::Point{-1, -1};
}

// u = frac((atan2(y, x) - angle) / 2 pi) and v = acos(z) / pi from the top, of the normal in the globe's coordinates.
TEST(Groningen, TexturesLieOnSpheresAsInTheCourse) {
  const std::string plain = "'radius': 2";
  for (const R3::Vector& given : {R3::Vector{1, 2, 3}, {-1, 0.5, 0.2}, {0.3, -1, -2}}) {
    const R3::Vector n = R3::Unit(given);
    const double u = std::atan2(n.y, n.x) / (2 * std::numbers::pi), v = std::acos(n.z) / std::numbers::pi;
    const R2::Point place = TexturePlace(plain, n);
    EXPECT_NEAR(place.x, u - std::floor(u), 1e-12);
    EXPECT_NEAR(1 - place.y, v, 1e-12);
    const R2::Point turned = TexturePlace(plain + ", 'angle': 90", n);
    EXPECT_NEAR(turned.x, u - 0.25 - std::floor(u - 0.25), 1e-12);
    EXPECT_NEAR(1 - turned.y, v, 1e-12);
  }
}

TEST(Groningen, AnAxisTurnsThePoleByTheSmallestRotation) {
  const R3::Vector axis = R3::Unit({0, 1, 0.7});
  for (const char* keys :
       {"'radius': [2, [0, 1, 0.7]]", "'radius': 2, 'axis': [0, 1, 0.7]", "'radius': 2, 'rotation': [0, 1, 0.7]"}) {
    EXPECT_NEAR(TexturePlace(keys, axis).y, 1, 1e-7) << keys;
    EXPECT_NEAR(TexturePlace(keys, {1, 0, 0}).y, 0.5, 1e-12) << keys;
    const double u = TexturePlace(keys, {1, 0, 0}).x;
    EXPECT_NEAR(u, std::round(u), 1e-12) << keys << ": the axis of the rotation stays at the seam";
  }
  for (const char* opposite : {"'radius': [2, [0, 0, -1]]", "'radius': [2, [0.001, 0, -1]]"})
    EXPECT_NEAR(TexturePlace(opposite, {0, 0, -1}).y, 1, 1e-3) << opposite;
}

TEST(Groningen, ASideSetsLongitude0) {
  for (const char* keys :
       {"'radius': 2, 'axis': [0, 1, 0], 'side': [1, 5, 0]", "'radius': 2, 'north': [0, 1, 0], 'start': [1, 0, 0]"}) {
    EXPECT_NEAR(TexturePlace(keys, {0, 1, 0}).y, 1, 1e-7) << keys;
    EXPECT_NEAR(TexturePlace(keys, R3::Unit({1, 0, -1e-9})).x, 0, 1e-8) << keys;
    EXPECT_NEAR(TexturePlace(keys, {0, 0, -1}).x, 0.25, 1e-12) << keys;
  }
}

TEST(Groningen, AQuaternionTurnsAGlobe) {
  // A quarter turn about x takes the pole from +z to -y.
  const double half = std::sqrt(0.5);
  const std::string keys =
      "'radius': 2, 'quaternion': [" + std::to_string(half) + ", " + std::to_string(half) + ", 0, 0]";
  EXPECT_NEAR(TexturePlace(keys, {0, -1, 0}).y, 1, 1e-3);
}

TEST(Groningen, EverySpellingOfATriangleAndAQuadIsTaken) {
  const std::string material = "'material': {'color': [1, 1, 1], 'kd': 1}}";
  const std::array<std::string, 4> corners{"[0, 0, 0]", "[4, 0, 0]", "[4, 4, 0]", "[0, 4, 0]"};
  const auto object = [&](const std::string& type, const std::vector<std::string>& keys) {
    std::string text = "{'type': '" + type + "', ";
    for (std::size_t i = 0; i < keys.size(); ++i) text += "'" + keys[i] + "': " + corners[i] + ", ";
    return text + material;
  };
  const R3::Ray inside{{3, 1, 9}, {0, 0, -1}}, beside{{1, 3, 9}, {0, 0, -1}};
  for (const std::vector<std::string>& keys :
       std::vector<std::vector<std::string>>{{"v0", "v1", "v2"},
                                             {"v1", "v2", "v3"},
                                             {"a", "b", "c"},
                                             {"p0", "p1", "p2"},
                                             {"p1", "p2", "p3"},
                                             {"position1", "position2", "position3"},
                                             {"point1", "point2", "point3"},
                                             {"point_1", "point_2", "point_3"},
                                             {"corner1", "corner2", "corner3"}}) {
    const Scene scene = WithKeys("", object("triangle", keys)).scene;
    EXPECT_TRUE(Trace(scene, inside)) << keys[0];
    EXPECT_FALSE(Trace(scene, beside)) << keys[0];
  }
  for (const std::vector<std::string>& keys :
       std::vector<std::vector<std::string>>{{"v0", "v1", "v2", "v3"},
                                             {"a", "b", "c", "d"},
                                             {"p0", "p1", "p2", "p3"},
                                             {"p1", "p2", "p3", "p4"},
                                             {"point1", "point2", "point3", "point4"}}) {
    const Scene scene = WithKeys("", object("quad", keys)).scene;
    EXPECT_TRUE(Trace(scene, inside)) << keys[0];
    EXPECT_TRUE(Trace(scene, beside)) << keys[0];
  }
  EXPECT_TRUE(Trace(
      WithKeys("", "{'type': 'quadrilateral', 'position': [0, 0, 0], 'up': [0, 4, 0], 'side': [4, 0, 0], " + material)
          .scene,
      beside));
}

TEST(Groningen, AQuadGivenRowByRowIsReportedAndRead) {
  const ParsedScene parsed =
      WithKeys("",
               "{'type': 'quad', 'p0': [0, 0, 0], 'p1': [0, 4, 0], 'p2': [4, 0, 0], 'p3': [4, 4, 0], "
               "'material': {'color': [1, 1, 1]}}");
  ASSERT_EQ(parsed.warnings.size(), 1u);
  EXPECT_TRUE(Contains(parsed.warnings[0], "the sides of this quad cross"));
  for (const R3::Point& p : {R3::Point{1, 2, 9}, {3, 2, 9}, {2, 1, 9}, {2, 3, 9}})
    EXPECT_TRUE(Trace(parsed.scene, {p, {0, 0, -1}})) << p.x << " " << p.y;
}

TEST(Groningen, AConcavePolygonHasItsNotch) {
  const Scene scene =
      WithKeys("",
               "{'type': 'polygon', 'vertices': [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0]], "
               "'material': {'color': [1, 1, 1]}}")
          .scene;
  EXPECT_TRUE(Trace(scene, {{0.5, 2, 9}, {0, 0, -1}}));
  EXPECT_TRUE(Trace(scene, {{3.5, 2, 9}, {0, 0, -1}}));
  EXPECT_FALSE(Trace(scene, {{2, 2, 9}, {0, 0, -1}}));
}

TEST(Groningen, SolidsArePlacedByTheirKeys) {
  const std::string material = "'material': {'color': [1, 1, 1]}}";
  const auto depth = [&](const std::string& keys, const R3::Ray& ray) {
    const auto met = Trace(WithKeys("", "{" + keys + ", " + material).scene, ray);
    return met ? met->t : -1;
  };
  const R3::Ray along_x{{-10, 0.5, 0}, {1, 0, 0}}, down{{0.25, 10, 0}, {0, -1, 0}};
  EXPECT_NEAR(
      depth("'type': 'cylinder', 'position': [0, 0, 0], 'direction': [3, 0, 0], 'radius': 1, 'height': 2", along_x), 10,
      1e-12);
  EXPECT_NEAR(depth("'type': 'cylinder', 'p1': [2, 0, 0], 'p2': [5, 0, 0], 'r': 1", along_x), 12, 1e-12);
  EXPECT_NEAR(depth("'type': 'cone', 'position': [0, 1, 0], 'direction': [0, 1, 0], 'radius': 1, 'height': 4", down), 6,
              1e-12);
  EXPECT_NEAR(depth("'type': 'cone', 'position': [0, 5, 0], 'up': [0, -4, 0], 'radius': 1", down), 5, 1e-12);
  EXPECT_NEAR(depth("'type': 'torus', 'position': [0, 0, 0], 'radius': 2, 'alpha': 0.5", {{2, 0, 9}, {0, 0, -1}}), 8.5,
              1e-9);
  EXPECT_NEAR(depth("'type': 'torus', 'position': [0, 0, 0], 'radius': 2, 'alpha': 0.5", {{0, 0, 9}, {0, 0, -1}}), -1,
              0);
  EXPECT_NEAR(depth("'type': 'torus', 'position': [0, 0, 0], 'direction': [0, 1, 0], 'radius': 2, 'tube': 0.5",
                    {{2, 9, 0}, {0, -1, 0}}),
              8.5, 1e-9);
  EXPECT_NEAR(depth("'type': 'box', 'min': [-1, 0, -1], 'max': [1, 2, 1]", along_x), 9, 1e-12);
  // At y = 0.5 of a height of 2 the half width is sqrt(0.75) of the radius.
  EXPECT_NEAR(depth("'type': 'paraboloid', 'position': [0, 0, 0], 'radius': 1, 'height': 2", along_x),
              10 - std::sqrt(0.75), 1e-12);
  // 2 (1 - d^2 / 9)^3 = 0.25 at d = 3 sqrt(1 / 2); a missing strength is 1.
  for (const char* blob : {"'type': 'blob', 'threshold': 0.25, 'balls': [{'position': [0, 0.5, 0], 'radius': 3, "
                           "'strength': 2}]",
                           "'type': 'metaball', 'threshold': 0.125, 'components': [{'center': [0, 0.5, 0], 'r': 3}]"})
    EXPECT_NEAR(depth(blob, along_x), 10 - 3 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(depth("'type': 'implicit', 'formula': 'x^2 + y^2 + z^2 - 1', 'min': [-2, -2, -2], 'max': [2, 2, 2]",
                    along_x),
              10 - std::sqrt(0.75), 1e-12);
  const std::string sheet =
      "'points': [[-3, 1, 3], [-1, 1, 3], [1, 1, 3], [3, 1, 3], [-3, 1, 1], [-1, 1, 1], [1, 1, 1], [3, 1, 1], "
      "[-3, 1, -1], [-1, 1, -1], [1, 1, -1], [3, 1, -1], [-3, 1, -3], [-1, 1, -3], [1, 1, -3], [3, 1, -3]]";
  for (const char* kind : {"bezier", "bspline"})
    EXPECT_NEAR(depth(("'type': '" + std::string(kind) + "', " + sheet).c_str(), down), 9, 1e-12) << kind;
  EXPECT_NEAR(
      depth("'type': 'box', 'position': [0, 0, 0], 'dimension': [2, 4, 6], 'rotation': [0, 1.5707963267948966, 0]",
            along_x),
      7, 1e-9);
  EXPECT_NEAR(
      depth("'type': 'box', 'position': [1, 0, -1], 'side': [2, 0, 0], 'up': [0, 2, 0], 'depth': [0, 0, 2]", along_x),
      11, 1e-12);
  // A single length points away from a viewer for whom side points right and up points up.
  const std::string sides = "'side': [2, 0, 0], 'up': [0, 2, 0], 'depth': 2";
  EXPECT_NEAR(depth("'type': 'box', 'position': [1, 0, 1], " + sides, along_x), 11, 1e-12);
  EXPECT_NEAR(depth("'type': 'box', 'position': [1, 0, -1], " + sides, along_x), -1, 0);
  EXPECT_NEAR(depth("'type': 'cube', 'position': [0, 0, 0], 'size': 4", along_x), 8, 1e-12);
  EXPECT_NEAR(depth("'type': 'circle', 'center': [0, 3, 0], 'N': [0, 1, 0], 'radius': 1", down), 7, 1e-5);
  EXPECT_NEAR(depth("'type': 'circle', 'center': [1.5, 3, 0], 'N': [0, 1, 0], 'radius': 1", down), -1, 0);
  EXPECT_NEAR(depth("'type': 'plane', 'position': [0, 1, 0], 'normal': [0, 2, 0]", down), 9, 1e-12);
  EXPECT_NEAR(depth("'type': 'plane', 'O': [0, 1, 0], 'N': [0, 1, 0]", down), 9, 1e-12);
  EXPECT_NEAR(depth("'type': 'plane', 'normal': [0, 2, 0], 'distance': 3", down), 7, 1e-12);
}

TEST(Groningen, BadDistancesAreNoErrorWhenUnused) {
  const ParsedScene phong = WithKeys("'DistMin': -5, 'DistMax': 900");
  EXPECT_EQ(SettingOf(phong.scene, "zbuffer_range"), "(none)");
  EXPECT_THROW(WithKeys("'RenderMode': 'zbuffer', 'DistMin': -5, 'DistMax': 900"), SceneErrors);
}

TEST(Groningen, MeshesAreFoundWithoutTheirExtensionAndPlaced) {
  const Folder folder;
  folder.Write("flag.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const std::string key : {"file", "filename", "fileName", "path", "model", "modelPath", "name"}) {
    const Scene scene = Groningen("{'Eye': [0, 0, 9], 'Objects': [{'type': 'mesh', '" + key +
                                      "': 'flag', 'scale': [4, 2, 1], 'position': [10, 0, 0], 'rotation': "
                                      "[0, 0, 1.5707963267948966], 'material': {'color': [1, 1, 1]}}]}",
                                  folder)
                            .scene;
    EXPECT_TRUE(Trace(scene, {{9.5, 2, 9}, {0, 0, -1}})) << key;
    EXPECT_FALSE(Trace(scene, {{10.5, 1, 9}, {0, 0, -1}})) << key;
    EXPECT_EQ(scene.files.size(), 2u);
  }
}

TEST(Groningen, SizedMeshesAreCenteredAndSpanTwiceTheirSize) {
  const Folder folder;
  folder.Write("flag.obj", "v 10 0 0\nv 14 0 0\nv 10 2 0\nv 14 2 0\nf 1 2 4 3\n");
  const Scene scene = Groningen("{'Eye': [0, 0, 9], 'Objects': [{'type': 'mesh', 'file': 'flag', 'size': 50, "
                                "'position': [7, 0, 0], 'material': {'color': [1, 1, 1]}}]}",
                                folder)
                          .scene;
  for (const double sign : {-1.0, 1.0}) {  // 100 wide, 50 high
    EXPECT_TRUE(Trace(scene, {{7 + sign * 49.9, 0, 9}, {0, 0, -1}}));
    EXPECT_FALSE(Trace(scene, {{7 + sign * 50.1, 0, 9}, {0, 0, -1}}));
    EXPECT_TRUE(Trace(scene, {{7, sign * 24.9, 9}, {0, 0, -1}}));
    EXPECT_FALSE(Trace(scene, {{7, sign * 25.1, 9}, {0, 0, -1}}));
  }
}

TEST(Groningen, MeshesMayHaveFileMaterialsAndComputedNormals) {
  const Folder folder;
  folder.Write("roof.mtl", "newmtl red\nKd 1 0 0\n");
  folder.Write("roof.obj", "mtllib roof.mtl\nv 0 0 0\nv 1 0 0.1\nv 1 1 0.1\nv 2 0 0\nf 1 2 3\nusemtl red\nf 2 4 3\n");
  const ParsedScene parsed = Groningen(
      "{'Eye': [0, 0, 9], 'Objects': [{'type': 'mesh', 'file': 'roof', 'materials': true, 'smooth_angle': 40, "
      "'material': {'color': [0, 0, 1], 'kd': 1}}]}",
      folder);
  EXPECT_TRUE(parsed.warnings.empty());
  const auto& group = parsed.scene.root.children.at(0);
  ASSERT_EQ(group.children.size(), 2u);
  const auto kd = [&](std::size_t i) {
    return parsed.scene.materials.at(static_cast<std::size_t>(group.children[i].material)).kd;
  };
  EXPECT_EQ(kd(0), (R2::Color{0, 0, 1}));
  EXPECT_EQ(kd(1), (R2::Color{1, 0, 0}));
  for (const Node& node : group.children) {
    const auto& mesh = dynamic_cast<const R3::Mesh&>(*node.shape);
    ASSERT_TRUE(mesh.IsSmooth());
    // On the ridge both have the mean of the slopes, which are 5.7 degrees either way, weighted by their angles.
    for (std::size_t i = 0; i < mesh.Data().positions.size(); ++i) {
      if (mesh.Data().positions[i] == R3::Point{1, 1, 0.1}) {
        EXPECT_NEAR(mesh.Data().normals[i].x, 0, 1e-2);
      }
    }
  }
}

TEST(Groningen, AMeshMayHaveANameAndAFile) {
  const Folder folder;
  folder.Write("flag.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const ParsedScene parsed = Groningen(
      "{'Eye': [0, 0, 9], 'Objects': [{'type': 'mesh', 'name': 'a flag', 'file': 'flag', 'material': "
      "{'color': [1, 1, 1]}}]}",
      folder);
  EXPECT_TRUE(Trace(parsed.scene, {{0.25, 0.25, 9}, {0, 0, -1}}));
  for (const std::string& warning : parsed.warnings) EXPECT_FALSE(Contains(warning, "name")) << warning;
}

#ifdef RAYPRO_YAML
TEST(Groningen, MeshesMayBeNamedThroughTheParentFolder) {
  const Folder folder;
  const std::filesystem::path mesh = folder.Write("flag.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string name = "../" + mesh.parent_path().filename().string() + "/flag.obj";
  const ParsedScene parsed = Groningen("{'Eye': [0, 0, 9], 'Objects': [{'type': 'mesh', 'filename': '" + name +
                                           "', 'material': {'color': [1, 1, 1]}}]}",
                                       folder);
  EXPECT_TRUE(Trace(parsed.scene, {{0.25, 0.25, 9}, {0, 0, -1}}));
}

TEST(Groningen, BothFormsOfASceneAreTheSame) {
  const Folder folder;
  const auto yaml = folder.Write(
      "a.yaml",
      "# remark\r\n---\r\nEye: [200,200,1000]\r\nShadows: yes\r\nLights:\r\n- position: [0,0,9]\r\n"
      "  color: [1.5,1,1]\r\nObjects:\r\n- type: sphere\r\n  position:\r\n  - 90\r\n  - 320\r\n  - 100\r\n  radius: "
      "50.0000000000000000000000000000000000001\r\n  material: {color: [0, 0, 1], ka: 0.2, kd: 0.7, ks: \"0.5\", n: "
      "64}\r\n");
  const auto json = folder.Write(
      "a.json",
      "{\"Eye\": [200, 200, 1000], \"Shadows\": true, \"Lights\": [{\"position\": [0, 0, 9], \"color\": [1.5, 1, 1]}], "
      "\"Objects\": [{\"type\": \"sphere\", \"position\": [90, 320, 100], \"radius\": 50, \"material\": {\"color\": "
      "[0, 0, 1], "
      "\"ka\": 0.2, \"kd\": 0.7, \"ks\": 0.5, \"n\": 64}}]}");
  const ParsedScene a = Parse(yaml, {}), b = Parse(json, {});
  EXPECT_EQ(a.scene.root.bounds.low, b.scene.root.bounds.low);
  EXPECT_EQ(a.scene.materials.back().kd, b.scene.materials.back().kd);
  EXPECT_EQ(a.scene.ambient, b.scene.ambient);
  ASSERT_EQ(a.scene.settings.size(), b.scene.settings.size());
  for (std::size_t i = 0; i < a.scene.settings.size(); ++i)
    EXPECT_EQ(a.scene.settings[i].value, b.scene.settings[i].value) << a.scene.settings[i].option;
}

#endif

}  // namespace
}  // namespace ray

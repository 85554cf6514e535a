// The meaning of a well-formed text scene of COMP30019. Its world is left-handed with z into the screen; ours is its
// mirror image, every z negated.
#include <gtest/gtest.h>

#include <map>

#include "R3/Mesh.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

const std::string red_material = "Material \"Red\" Diffuse (1, .5, .25) 1\n";

ParsedScene ParsedComp30019(std::string_view text) {
  const Folder folder;
  return Parse(folder.Write("scene.txt", text), {});
}
Scene SceneOfComp30019(std::string_view text) { return ParsedComp30019(text).scene; }

Material MaterialOf(const std::string& kind_color_index) {
  return SceneOfComp30019("Material \"M\" " + kind_color_index).materials.at(1);
}

const R3::Mesh& MeshOf(const Node& node) { return dynamic_cast<const R3::Mesh&>(*node.shape); }

const R2::Color black, white{1, 1, 1};

TEST(Comp30019, TheWorldIsMirrored) {
  const Scene scene = SceneOfComp30019(red_material + "Sphere \"S\" (1, 2, 3) .5 \"Red\"\n");
  ASSERT_EQ(scene.root.children.size(), 1u);
  EXPECT_EQ(scene.root.children[0].bounds, (R3::Box{{0.5, 1.5, -3.5}, {1.5, 2.5, -2.5}}));
  EXPECT_EQ(scene.root.children[0].material, 1);
}

TEST(Comp30019, TheCameraLooksIntoTheScreenWith60DegreesOfWidth) {
  const Camera camera = SceneOfComp30019("").camera;
  EXPECT_EQ(camera.eye, R3::Point{});
  EXPECT_EQ(camera.towards, (R3::Vector{0, 0, -1}));
  EXPECT_EQ(camera.up, (R3::Vector{0, 1, 0}));
  EXPECT_EQ(camera.right, (R3::Vector{1, 0, 0}));
  EXPECT_NEAR(std::tan(camera.xfov), 1 / std::sqrt(3), 1e-15);
}

TEST(Comp30019, TheViewOfTheCommandLineIsInTheWorldOfTheFile) {
  const Folder folder;
  ParseOptions options;
  options.camera.eye = R3::Point{1, 2, -3};
  options.camera.target = R3::Point{1, 2, 9};  // into the screen
  options.camera.up = R3::Vector{0, 4, 1};
  const Camera camera = Parse(folder.Write("scene.txt", ""), options).scene.camera;
  EXPECT_EQ(camera.eye, (R3::Point{1, 2, 3}));
  EXPECT_EQ(camera.towards, (R3::Vector{0, 0, -1}));
  EXPECT_EQ(camera.up, (R3::Vector{0, 1, 0}));
}

TEST(Comp30019, NoDefaultsAreAdded) {
  const Scene scene = SceneOfComp30019(red_material);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.ambient, black);
  EXPECT_EQ(scene.background, black);
}

TEST(Comp30019, TheCoursesRulesAreSettingsOfTheScene) {
  std::map<std::string, std::string> settings;
  for (const SceneSetting& setting : SceneOfComp30019("").settings) {
    settings[setting.option] = setting.value;
    EXPECT_EQ(setting.origin, "COMP30019");
  }
  const std::map<std::string, std::string> rules{{"width", "400"},  {"height", "400"},      {"sampler", "grid"},
                                                 {"samples", "1"},  {"max_depth", "10"},    {"min_luminance", "0"},
                                                 {"fresnel", "on"}, {"bytes", "truncated"}, {"emissive_solids", "on"},
                                                 {"emissive_meshes", "whole"}, {"emission", "color"}};
  EXPECT_EQ(settings, rules);
}

TEST(Comp30019, ADiffuseMaterialHasItsColorAndNothingElse) {
  const Material m = MaterialOf("Diffuse (1, .5, .25) 1");
  EXPECT_EQ(m.kd, (R2::Color{1, 0.5, 0.25}));
  for (const R2::Color& other : {m.ka, m.ks, m.kr, m.kt, m.emission, m.absorb}) EXPECT_EQ(other, black);
  EXPECT_EQ(m.coat, 0);
}

TEST(Comp30019, AMirrorIgnoresItsColor) {
  const Material m = MaterialOf("Reflective (1, .5, .25) 1");
  EXPECT_EQ(m.kr, white);
  for (const R2::Color& other : {m.ka, m.kd, m.ks, m.kt, m.emission}) EXPECT_EQ(other, black);
}

TEST(Comp30019, GlassIsClearAndItsColorIsItsAbsorption) {
  const Material m = MaterialOf("Refractive (1, .5, .25) 1.4");
  EXPECT_EQ(m.kt, white);
  EXPECT_EQ(m.ir, 1.4);
  EXPECT_EQ(m.absorb, (R2::Color{1, 0.5, 0.25}));
  for (const R2::Color& other : {m.ka, m.kd, m.ks, m.kr, m.emission}) EXPECT_EQ(other, black);
}

TEST(Comp30019, AnEmissiveMaterialIsNotLit) {
  const Material m = MaterialOf("Emissive (1, .5, .25) 1");
  EXPECT_EQ(m.emission, (R2::Color{1, 0.5, 0.25}));
  for (const R2::Color& other : {m.ka, m.kd, m.ks, m.kr, m.kt}) EXPECT_EQ(other, black);
}

TEST(Comp30019, GlossyIsCoatedDiffuseAndIndexOneMeansVarnish) {
  EXPECT_EQ(MaterialOf("Glossy (1, .5, .25) 1").coat, 1.5);
  const Material m = MaterialOf("Glossy (1, .5, .25) 1.3");
  EXPECT_EQ(m.coat, 1.3);
  EXPECT_EQ(m.kd, (R2::Color{1, 0.5, 0.25}));
  for (const R2::Color& other : {m.ka, m.ks, m.kr, m.kt, m.emission}) EXPECT_EQ(other, black);
}

TEST(Comp30019, ModeFlatShowsTheColorOfEveryKind) {
  for (const char* kind : {"Diffuse", "Reflective", "Refractive", "Emissive", "Glossy"})
    EXPECT_EQ(MaterialOf(kind + std::string(" (1, .5, .25) 1.4")).color, (R2::Color{1, 0.5, 0.25})) << kind;
}

TEST(Comp30019, AKindMayBeGivenByItsNumber) {
  EXPECT_EQ(MaterialOf("0 (1, .5, .25) 1").kd, (R2::Color{1, 0.5, 0.25}));
  EXPECT_EQ(MaterialOf("1 (1, .5, .25) 1").kr, white);
  EXPECT_EQ(MaterialOf("2 (1, .5, .25) 1").kt, white);
  EXPECT_EQ(MaterialOf("3 (1, .5, .25) 1").emission, (R2::Color{1, 0.5, 0.25}));
  EXPECT_EQ(MaterialOf("4 (1, .5, .25) 1").coat, 1.5);
}

TEST(Comp30019, APointLightDoesNotFallOff) {
  const Scene scene = SceneOfComp30019("PointLight \"L\" (1, 2, 3) (.25, .5, .75)\n");
  ASSERT_EQ(scene.lights.size(), 1u);
  const auto light = scene.lights[0]->Illuminate({1, 2, 97}, {});
  ASSERT_TRUE(light);
  EXPECT_EQ(light->to_light, (R3::Vector{0, 0, -100}));
  EXPECT_EQ(light->irradiance, (R2::Color{0.25, 0.5, 0.75}));
}

/// Returns light in the course's world, z negated, traveling in its own direction.
std::optional<R3::Intersection> SeenAlong(const R3::Shape& shape, const R3::Point& from, const R3::Vector& towards) {
  const R3::Ray ray{{from.x, from.y, -from.z}, {towards.x, towards.y, -towards.z}};
  const auto hit = shape.Intersect(ray, 0);
  if (!hit) return {};
  return shape.At(ray, *hit, 0);
}

TEST(Comp30019, TrianglesFaceTheClockwiseSide) {
  const Scene scene = SceneOfComp30019(red_material + "Triangle \"T\" (-1, -1, 2) (0, 1, 2) (1, -1, 2) \"Red\"\n");
  const auto at = SeenAlong(*scene.root.children.at(0).shape, {0, 0, 0}, {0, 0, 1});
  ASSERT_TRUE(at);
  EXPECT_EQ(AsVector(at->normal), (R3::Vector{0, 0, 1}));  // towards the viewer, whose world is mirrored
}

TEST(Comp30019, APlanesNormalIsNormalized) {
  const Scene scene = SceneOfComp30019(red_material + "Plane \"P\" (0, 0, 4) (0, 0, -3) \"Red\"\n");
  const auto at = SeenAlong(*scene.root.children.at(0).shape, {1, 2, 0}, {0, 0, 1});
  ASSERT_TRUE(at);
  EXPECT_EQ(at->position, (R3::Point{1, 2, -4}));
  EXPECT_EQ(AsVector(at->normal), (R3::Vector{0, 0, 1}));
}

const std::string triangle_file = "v 0 0 0.5\nv 1 0 0.5\nv 0 1 0.5\nvn 0 0 1\nf 1//1 2//1 3//1\n";

TEST(Comp30019, RightHandedModelsKeepZAndAreScaledThenMoved) {
  const Folder folder;
  folder.Write("tri.obj", triangle_file);
  const Scene scene =
      Parse(folder.Write("scene.txt", red_material + "ObjModel \"M\" \"tri.obj\" (10, 20, 30) 2 \"Red\"\n"), {}).scene;
  const Node& placed = scene.root.children.at(0);
  const R3::Box expected{{10, 20, -29}, {12, 22, -29}};
  EXPECT_EQ(placed.bounds, expected);
  EXPECT_EQ(MeshOf(placed.children.at(0)).Corners(0)[0], (R3::Point{0, 0, 0.5}));
}

TEST(Comp30019, VertexNormalsAreInterpolated) {
  const Folder folder;
  folder.Write("tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\nf 1//1 2//2 3//3\n");
  const Scene scene =
      Parse(folder.Write("scene.txt", red_material + "ObjModel \"M\" \"tri.obj\" (0, 0, 0) 1 \"Red\"\n"), {}).scene;
  const auto at = SeenAlong(*scene.root.children.at(0).children.at(0).shape, {1 / 3.0, 1 / 3.0, -1}, {0, 0, 1});
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->shading_normal.x, 1 / std::sqrt(3), 1e-12);
  EXPECT_NEAR(at->shading_normal.y, 1 / std::sqrt(3), 1e-12);
}

TEST(Comp30019, ModelsAreFoundFromTheSceneOrItsParentFolder) {
  const Folder folder;
  folder.Write("tests/models/tri.obj", triangle_file);
  for (const char* name : {"models/tri.obj", "tests/models/tri.obj"}) {
    const auto file =
        folder.Write("tests/scene.txt", red_material + "ObjModel \"M\" \"" + name + "\" (0, 0, 0) 1 \"Red\"\n");
    EXPECT_EQ(Parse(file, {}).scene.root.children.size(), 1u) << name;
  }
}

TEST(Comp30019, NumbersAreReadAsTheCoursesFilesWriteThem) {
  const Scene scene = SceneOfComp30019(red_material + "Sphere \"S\" (-.5,+2,1e1) .25 \"Red\"");
  EXPECT_EQ(scene.root.children.at(0).bounds, (R3::Box{{-0.75, 1.75, -10.25}, {-0.25, 2.25, -9.75}}));
}

TEST(Comp30019, WhiteSpaceAroundPunctuationDoesNotCount) {
  for (const char* line : {"Sphere\"S\"(0,0,2).5\"Red\"", "  Sphere  \" S \" ( 0 , 0 , 2 )\t.5 \" Red \"  "})
    EXPECT_EQ(SceneOfComp30019(red_material + line).root.children.size(), 1u) << line;
}

TEST(Comp30019, AcceptsAnyLineEndAndAByteOrderMark) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string text = "\xEF\xBB\xBFMaterial \"Red\" Diffuse (1, .5, .25) 1" + std::string(end) + end +
                             "Sphere \"S\" (0, 0, 2) .5 \"Red\"" + end;
    const ParsedScene parsed = ParsedComp30019(text);
    EXPECT_EQ(parsed.scene.root.children.size(), 1u);
    EXPECT_TRUE(parsed.warnings.empty());
  }
}

TEST(Comp30019, MaterialsLightsAndEntitiesHaveSeparateNames) {
  const Scene scene = SceneOfComp30019(
      "Material \"A\" Diffuse (1, 1, 1) 1\nPointLight \"A\" (0, 0, 0) (1, 1, 1)\nSphere \"A\" (0, 0, 2) 1 \"A\"\n");
  EXPECT_EQ(scene.root.children.size(), 1u);
  EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(Comp30019, ManyNodesEndTheReading) {
  ParseOptions few;
  few.max_nodes = 2;
  std::string text = red_material;
  for (int i = 0; i < 5; ++i) text += "Sphere \"S" + std::to_string(i) + "\" (0, 0, 2) .5 \"Red\"\n";
  const Folder folder;
  folder.Write("scene.txt", text);
  EXPECT_TRUE(Contains(ReportOf(folder, "scene.txt", few), "scene.txt:4:1: error: the scene has more than 2 nodes"));
}

TEST(Comp30019, UnknownMaterialsAmongThousandsAreReportedQuickly) {
  std::string text;
  for (int i = 0; i < 10000; ++i) text += "Material \"M" + std::to_string(i) + "\" Diffuse (1, 1, 1) 1\n";
  for (int i = 0; i < 10000; ++i)
    text += "Sphere \"S" + std::to_string(i) + "\" (0, 0, 2) .5 \"N" + std::to_string(i) + "\"\n";
  const Folder folder;
  folder.Write("scene.txt", text);
  EXPECT_TRUE(Contains(ReportOf(folder, "scene.txt"), "and at least 980 more errors"));
}

}  // namespace
}  // namespace ray

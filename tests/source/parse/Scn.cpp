// The meaning of a well-formed .scn file. Numbers in names are those of the manual's list of traps.

#include <gtest/gtest.h>

#include <cmath>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

TEST(Scn, Trap1_SignsAndPointsOfRealFilesAreRead) {
  const Scene scene = ParseText("line -1  +20 .5 -.7071  01.57 5. 1e-3\n").scene;
  ASSERT_EQ(scene.root.children.size(), 1u);
  EXPECT_EQ(scene.root.children[0].line->start, (R3::Point{20, 0.5, -0.7071}));
  EXPECT_EQ(scene.root.children[0].line->end, (R3::Point{1.57, 5, 0.001}));
}

TEST(Scn, AMaterialLandsFieldForField) {
  const Material m = ParseText("material 1 2 3  4 5 6  7 8 9  10 11 12  13 14 15  16 1.7 0").scene.materials.at(1);
  EXPECT_EQ(m.ka, (R2::Color{1, 2, 3}));
  EXPECT_EQ(m.kd, (R2::Color{4, 5, 6}));
  EXPECT_EQ(m.ks, (R2::Color{7, 8, 9}));
  EXPECT_EQ(m.kr, m.ks);
  EXPECT_EQ(m.kt, (R2::Color{10, 11, 12}));
  EXPECT_EQ(m.emission, (R2::Color{13, 14, 15}));
  EXPECT_EQ(m.n, 16);
  EXPECT_EQ(m.ir, 1.7);
  EXPECT_FALSE(m.texture);
}

TEST(Extremes, F3_Trap2_AnIndexOfZeroMeansOneAndExtremesStay) {
  const auto index = [](const std::string& ir) {
    return ParseText("material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 " + ir + " 0").scene.materials.at(1).ir;
  };
  EXPECT_EQ(index("0"), 1);
  EXPECT_EQ(index("1e-6"), 1e-6);
  EXPECT_EQ(index("1e6"), 1e6);
}

TEST(Scn, AMirrorHasItsOwnWeight) {
  const std::string material = "material 0 0 0  0 0 0  7 8 9  0 0 0  0 0 0  10 1 0\n";
  const Material m = ParseText(material + "mirror 0 .1 .2 .3").scene.materials.at(1);
  EXPECT_EQ(m.ks, (R2::Color{7, 8, 9}));
  EXPECT_EQ(m.kr, (R2::Color{0.1, 0.2, 0.3}));
}

TEST(Scn, AConflictingLaterPriorityWins) {
  const std::string material = "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  10 1.5 0\n";
  EXPECT_EQ(ParseText(material + "priority 0 1\npriority 0 2").scene.materials.at(1).priority, 2);
}

TEST(Scn, ViewAndCameraMayComeInAnyOrder) {
  const std::string camera = "camera 0 0 9  0 0 -1  0 1 0  .5 1 2\n", view = "view 2 .5 -1\n";
  for (const std::string& text : {camera + view, view + camera, view}) {
    const Camera c = ParseText(text).scene.camera;
    EXPECT_EQ(c.aspect, 2) << text;
    EXPECT_EQ(c.shift.x, 0.5) << text;
    EXPECT_EQ(c.shift.y, -1) << text;
  }
}

TEST(Scn, AMirroredViewSwapsLeftAndRightInAnyOrder) {
  const std::string camera = "camera 0 0 9  0 0 -1  0 1 0  .5 1 2\n", view = "view 0 0 0 mirrored\n";
  for (const std::string& text : {camera + view, view + camera, view})
    EXPECT_EQ(ParseText(text).scene.camera.right, (R3::Vector{-1, 0, 0})) << text;
  EXPECT_EQ(ParseText(camera + view + "view 0 0 0\n").scene.camera.right, (R3::Vector{1, 0, 0}));
}

TEST(Scn, ASettingIsKeptAsTextWithItsPosition) {
  const Scene scene = ParseText("set max_depth 2 # bounces\n\n  set motion 0 1\t2\nsphere -1 0 0 0 1").scene;
  ASSERT_EQ(scene.settings.size(), 2u);
  EXPECT_EQ(scene.settings[0].option, "max_depth");
  EXPECT_EQ(scene.settings[0].value, "2");
  EXPECT_EQ(scene.settings[1].value, "0 1 2");
  EXPECT_TRUE(scene.settings[1].origin.ends_with(":3:7")) << scene.settings[1].origin;
  EXPECT_EQ(scene.root.children.size(), 1u);
}

TEST(Scn, ASwitchIsSetByItsNameAlone) {
  const Scene scene = ParseText("set glossy\nset fresnel off\n").scene;
  EXPECT_EQ(scene.settings.at(0).value, "on");
  EXPECT_EQ(scene.settings.at(1).value, "off");
}

TEST(Scn, SrgbIsSetBeforeTheFirstImage) {
  const Folder folder;
  folder.Write("half.ppm", "P3 1 1 255 188 188 188 ");
  const std::string ball = "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 10 1 half.ppm\nsphere 0 0 0 0 1\n";
  folder.Write("linear.scn", "set srgb\n" + ball);
  folder.Write("off.scn", "set srgb off\n" + ball);
  const auto red = [&](const char* name) {
    return Parse(folder / name, {}).scene.materials.at(1).texture->image.At(0, 0).r;
  };
  EXPECT_NEAR(red("linear.scn"), 0.5029, 1e-4);  // IEC 61966-2-1
  EXPECT_NEAR(red("off.scn"), 188 / 255.0, 1e-7);
}

TEST(Scn, ASpecularMapIsDecodedAsATextureIs) {
  const Folder folder;
  folder.Write("half.ppm", "P3 1 1 255 188 188 188 ");
  const std::string ball = "material 0 0 0 1 1 1 .5 .5 .5 0 0 0 0 0 0 10 1 half.ppm\nspecular_map 0 half.ppm\n";
  for (const std::string srgb : {"", "set srgb\n"}) {
    const Material m = Parse(folder.Write("in.scn", srgb + ball), {}).scene.materials.at(1);
    ASSERT_TRUE(m.specular_map);
    EXPECT_EQ(m.specular_map, m.texture) << "read once";
  }
}

TEST(Scn, QuotedNamesMayContainBlanks) {
  const Folder folder;
  folder.Write("my \"wood\" #1.ppm", "P3 1 1 255 255 0 0 ");
  folder.Write("in.scn", "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 10 1 \"my \\\"wood\\\" #1.ppm\"\nsphere 0 0 0 0 1\n");
  EXPECT_TRUE(Parse(folder / "in.scn", {}).scene.materials.at(1).texture);
}

TEST(Scn, ATextureScaleHasTwoNumbers) {
  const std::string material = "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 10 1 0\n";
  EXPECT_EQ(ParseText(material + "texture_scale 0 2 .5").scene.materials.at(1).texture_scale, (R2::Vector{2, 0.5}));
}

TEST(Scn, Trap3_ABoxWithReversedCornersIsTheSameBox) {
  const Scene scene = ParseText("box -1  1 -1 -1  3 -3 1\nbox -1  1 -3 -1  3 -1 1\n").scene;
  EXPECT_EQ(scene.root.children.at(0).bounds, scene.root.children.at(1).bounds);
  EXPECT_EQ(scene.root.children.at(0).bounds, (R3::Box{{1, -3, -1}, {3, -1, 1}}));
}

TEST(Scn, Trap4_AGroupWithoutMaterialPassesOnTheEnclosingOne) {
  const Scene scene = ParseText(red + red + red + "begin 2" + identity + "begin -1" + identity +
                                "sphere -1 0 0 0 1\nsphere 1 0 0 0 1 end end")
                          .scene;
  const Node& outer = scene.root.children.at(0);
  EXPECT_EQ(outer.material, 3);  // 0 is the default
  const Node& inner = outer.children.at(0);
  EXPECT_EQ(inner.material, Node::inherit);
  EXPECT_EQ(inner.children.at(0).material, Node::inherit);
  EXPECT_EQ(inner.children.at(1).material, 2);
}

TEST(Scn, AnyNegativeIdInherits) {
  EXPECT_EQ(ParseText("sphere -7 0 0 0 1").scene.root.children.at(0).material, Node::inherit);
}

TEST(Scn, Trap5_InheritingAtTheTopOfAnIncludeMeansTheDefault) {
  const Folder folder;
  folder.Write("inner.scn", "sphere -1 0 0 0 1 begin -1" + identity + "sphere -1 0 0 0 1 end sphere -1 0 0 0 1");
  const Scene scene = Parse(folder.Write("scene.scn", red + "begin 0" + identity + "include inner.scn end"), {}).scene;
  const Node& group = scene.root.children.at(0);
  EXPECT_EQ(group.material, 1);
  ASSERT_EQ(group.children.size(), 3u);
  EXPECT_EQ(group.children[0].material, 0);
  EXPECT_EQ(group.children[1].material, 0);
  EXPECT_EQ(group.children[1].children.at(0).material, Node::inherit);
  EXPECT_EQ(group.children[2].material, 0);
}

TEST(Scn, AnIncludedFileCountsItsOwnMaterials) {
  const Folder folder;
  folder.Write("inner.scn", "material 0 0 0  0 1 0  0 0 0  0 0 0  0 0 0  10 1 0\nsphere 0 0 0 0 1");
  const Scene scene =
      Parse(folder.Write("scene.scn", red + "include inner.scn\n" + red + "sphere 1 0 0 0 1"), {}).scene;
  EXPECT_EQ(scene.materials.at(static_cast<std::size_t>(scene.root.children.at(0).material)).kd, (R2::Color{0, 1, 0}));
  EXPECT_EQ(scene.root.children.at(1).material, 3);
}

TEST(Scn, Trap6_ByDefaultAUnitSphereFills77PercentOfTheWidth) {
  const Scene scene = ParseText("sphere -1 0 0 0 1").scene;
  const double distance = scene.camera.eye.z;
  EXPECT_DOUBLE_EQ(distance, 3 * std::sqrt(3.0));
  const double silhouette = std::tan(std::asin(1 / distance));
  EXPECT_NEAR(silhouette / std::tan(scene.camera.xfov), 0.77, 0.005);
  EXPECT_EQ(scene.lights.size(), 2u);
}

TEST(Scn, Trap7_ABlackLightSuppressesTheDefaultLights) {
  const Scene scene = ParseText("point_light 0 0 0  0 3.5 1  0 0 1").scene;
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_TRUE(scene.lights[0]->IsBlack());
}

TEST(Scn, AnEmissiveTriangleAloneDoesNotSuppressThem) {
  const Scene scene = ParseText("material 0 0 0  0 0 0  0 0 0  0 0 0  4 4 4  10 1 0\ntri 0  0 0 0  1 0 0  0 1 0").scene;
  EXPECT_EQ(scene.lights.size(), 2u);
}

TEST(Scn, AnIncludedLightBelongsToTheScene) {
  const Folder folder;
  folder.Write("inner.scn", "dir_light 1 1 1  0 0 -1");
  folder.Write("none.scn", "");
  EXPECT_EQ(Parse(folder.Write("a.scn", "include inner.scn"), {}).scene.lights.size(), 1u);
  // The course's reader adds default lights at the end of every file; here they are added once.
  EXPECT_EQ(Parse(folder.Write("b.scn", "include none.scn dir_light 1 1 1  0 0 -1"), {}).scene.lights.size(), 1u);
}

TEST(Scn, Trap8_TheSpotCutOffComesBeforeTheExponent) {
  const Scene scene = ParseText("spot_light 1 1 1  0 0 0  0 0 -1  1 0 0  0.331 100").scene;
  const auto at = [&](double angle) {
    return scene.lights.at(0)->Illuminate({std::sin(angle), 0, -std::cos(angle)}, {}).has_value();
  };
  EXPECT_TRUE(at(0.32));
  EXPECT_FALSE(at(0.34));
}

TEST(Scn, TheMatrixIsReadByRowsForColumnVectors) {
  const Scene scene = ParseText("begin -1  1 2 3 4  5 6 7 8  9 10 12 11  0 0 0 1\nsphere -1 0 0 0 1 end").scene;
  EXPECT_EQ(scene.root.children.at(0).transform * R3::Point{}, (R3::Point{4, 8, 11}));
  EXPECT_EQ(scene.root.children.at(0).transform * (R3::Vector{1, 0, 0}), (R3::Vector{1, 5, 9}));
}

TEST(Scn, AGroupsBoxIsInItsParentsCoordinates) {
  const Scene scene =
      ParseText("begin -1  2 0 0 10  0 1 0 0  0 0 1 0  0 0 0 1\nbox -1 0 0 0 1 1 1\nbegin -1" + identity + "end end")
          .scene;
  const Node& group = scene.root.children.at(0);
  EXPECT_EQ(group.children.at(0).bounds, (R3::Box{{0, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(group.bounds, (R3::Box{{10, 0, 0}, {12, 1, 1}}));
  EXPECT_TRUE(group.children.at(1).bounds.IsEmpty());
  EXPECT_EQ(scene.root.bounds, group.bounds);
}

TEST(Scn, TheLastCameraBackgroundAndAmbientWin) {
  const Scene scene = ParseText(
                          "camera 1 1 1  0 0 -1  0 1 0  0.5 1 2\ncamera 3 2 1  0 0 -2  0 3 0.1  0.75  0.5 50\n"
                          "background 1 0 0 background 0 0.25 0 ambient 1 1 1 ambient 0 0 0.5")
                          .scene;
  EXPECT_EQ(scene.camera.eye, (R3::Point{3, 2, 1}));
  EXPECT_EQ(scene.camera.xfov, 0.75);
  EXPECT_EQ(scene.camera.near, 0.5);
  EXPECT_EQ(scene.camera.far, 50);
  EXPECT_EQ(scene.camera.towards, (R3::Vector{0, 0, -1}));
  EXPECT_EQ(scene.camera.up, (R3::Vector{0, 1, 0}));
  EXPECT_EQ(scene.background, (R2::Color{0, 0.25, 0}));
  EXPECT_EQ(scene.ambient, (R2::Color{0, 0, 0.5}));
}

TEST(Scn, EveryShapeOfTheTableIsACommand) {
  for (const R3::ShapeKind* kind : R3::ShapeKinds()) {
    std::string command = std::string(kind->name) + " -1";
    for (const double number : kind->example) command += " " + std::to_string(number);
    const ParsedScene parsed = ParseText(command);
    ASSERT_EQ(parsed.scene.root.children.size(), 1u) << command;
    EXPECT_TRUE(parsed.scene.root.children[0].shape) << command;
    EXPECT_TRUE(parsed.warnings.empty()) << command;
    EXPECT_TRUE(Contains(ReportOf(kind->name), std::string(kind->name) + ": mat_id is missing"));
  }
}

TEST(Scn, EveryLightOfTheTableIsACommand) {
  for (const LightKind* kind : LightKinds()) {
    std::string command = kind->name;
    for (const double number : kind->example) command += " " + std::to_string(number);
    EXPECT_EQ(ParseText(command).scene.lights.size(), 1u) << command;
    EXPECT_TRUE(Contains(ReportOf(kind->name), std::string(kind->name) + ": r is missing"));
  }
}

TEST(Scn, CommentsMayStandBetweenAnyTwoWords) {
  const Scene scene = ParseText("#a\nsphere # b\n -1 0 #c\n#\n 0 0 1 #aqua").scene;
  EXPECT_EQ(scene.root.children.size(), 1u);
}

TEST(Scn, CommentsMayTouchCommandsAndNumbers) {
  const Scene scene = ParseText("begin -1" + identity + "sphere#a ball\n -1 0 0 0 1#unit\nend#close sphere\n").scene;
  ASSERT_EQ(scene.root.children.size(), 1u);
  EXPECT_EQ(scene.root.children[0].children.size(), 1u);
}

TEST(Scn, ANodeKnowsWhereItStands) {
  const Folder folder;
  folder.Write("inner.scn", "\n\n  sphere -1 0 0 0 1");
  const Scene scene = Parse(folder.Write("scene.scn", "include inner.scn"), {}).scene;
  const Location at = scene.root.children.at(0).location;
  EXPECT_EQ(at.line, 3u);
  EXPECT_EQ(at.column, 3u);
  EXPECT_EQ(scene.files.at(at.file), (folder / "inner.scn").string());
  EXPECT_EQ(scene.files.at(0), (folder / "scene.scn").string());
}

const char* const triangle_off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(Scn, AMeshUsedTwiceIsOneMesh) {
  const Folder folder;
  folder.Write("sub/t.off", triangle_off);
  const Scene scene = Parse(folder.Write("scene.scn", "mesh -1 sub/t.off\nmesh -1 ./sub/../sub/t.off"), {}).scene;
  EXPECT_EQ(scene.root.children.at(0).shape, scene.root.children.at(1).shape);
  EXPECT_EQ(scene.root.children.at(0).bounds, (R3::Box{{0, 0, 0}, {1, 1, 0}}));
}

TEST(Scn, TheWordSmoothAfterAMeshSelectsItsNormals) {
  const Folder folder;
  folder.Write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 1\nf 1//1 2//1 3//1\n");
  const Scene scene = Parse(folder.Write("a.scn", "mesh -1 t.obj smooth mesh -1 t.obj"), {}).scene;
  const auto normal = [&](std::size_t i) {
    const R3::Ray ray{{0.25, 0.25, 1}, {0, 0, -1}};
    const R3::Shape& mesh = *scene.root.children.at(i).shape;
    const auto hit = mesh.Intersect(ray, 0);
    return hit ? mesh.At(ray, *hit, 0).shading_normal : R3::Normal{};
  };
  EXPECT_NEAR(normal(0).x, std::sqrt(0.5), 1e-15);
  EXPECT_EQ(normal(1), (R3::Normal{0, 0, 1}));
}

TEST(Scn, TexturesAreReadOnceAndDecodedInLinearWorkflows) {
  const Folder folder;
  folder.Write("t.ppm", std::string("P6 1 1 255\n") + "\x80\x80\x80");
  const std::string material = "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  10 1 t.ppm\n";
  folder.Write("scene.scn", material + material);
  const Scene straight = Parse(folder / "scene.scn", {}).scene;
  ASSERT_TRUE(straight.materials.at(1).texture);
  EXPECT_EQ(straight.materials.at(1).texture, straight.materials.at(2).texture);
  EXPECT_NEAR(straight.materials[1].texture->image.At(0, 0).r, 128 / 255.0, 1e-7);
  ParseOptions options;
  options.decode_srgb = true;
  const Scene linear = Parse(folder / "scene.scn", options).scene;
  EXPECT_NEAR(linear.materials.at(1).texture->image.At(0, 0).r, R2::DecodeSrgb(128 / 255.0), 1e-7);
}

TEST(Scn, QuadsAndPolygonsFaceWhereTheirCornersTurnLeft) {
  const Scene quad = ParseText("quad -1  0 0 0  2 0 0  2 1 0  0 1 0").scene;
  const auto& mesh = dynamic_cast<const R3::Mesh&>(*quad.root.children.at(0).shape);
  EXPECT_EQ(mesh.Elements(), 2);
  const R3::Ray ray{{1.5, 0.25, 3}, {0, 0, -1}};
  const auto hit = mesh.Intersect(ray, 0) ? mesh.Intersect(ray, 0) : mesh.Intersect(ray, 1);
  ASSERT_TRUE(hit);
  const R3::Intersection at = mesh.At(ray, *hit, mesh.Intersect(ray, 0) ? 0 : 1);
  EXPECT_EQ(at.normal, (R3::Normal{0, 0, 1}));
  EXPECT_NEAR(at.uv.x, 0.75, 1e-12);
  EXPECT_NEAR(at.uv.y, 0.25, 1e-12);

  // An arrowhead, whose notch is not part of it.
  const Scene arrow = ParseText("polygon -1 4  0 0 0  2 -1 0  0.5 0 0  2 1 0").scene;
  const auto& head = dynamic_cast<const R3::Mesh&>(*arrow.root.children.at(0).shape);
  const auto is_hit = [&](double x, double y) {
    const R3::Ray down{{x, y, 3}, {0, 0, -1}};
    return head.Intersect(down, 0) || head.Intersect(down, 1);
  };
  EXPECT_EQ(head.Elements(), 2);
  EXPECT_TRUE(is_hit(0.25, 0.01));
  EXPECT_TRUE(is_hit(1.5, 0.7));
  EXPECT_FALSE(is_hit(1, 0.01));
}

TEST(Scn, EnergyAboveOneIsAccepted) {
  EXPECT_TRUE(ParseText("material 10 10 10  10 10 10  10 10 10  10 10 10  4 4 4  10 1 0").warnings.empty());
}

double RadiusOfFirstSphere(const Folder& folder, const std::vector<std::string>& definitions) {
  ParseOptions options;
  options.definitions = definitions;
  return Parse(folder / "top.scn", options).scene.root.children.at(0).shape->MadeFrom()->arguments.at(3);
}

TEST(Scn, TheFirstDefinitionOfAVariableCounts) {
  const Folder folder;
  folder.Write("part.scn", "define r 3\nsphere -1 0 0 0 $r\n");
  folder.Write("top.scn", "include part.scn\n");
  EXPECT_EQ(RadiusOfFirstSphere(folder, {}), 3);
  EXPECT_EQ(RadiusOfFirstSphere(folder, {"r=5"}), 5);
  EXPECT_EQ(RadiusOfFirstSphere(folder, {"r=5", "r=7"}), 7);
  folder.Write("top.scn", "define r 4\ninclude part.scn\n");
  EXPECT_EQ(RadiusOfFirstSphere(folder, {}), 4);
  EXPECT_EQ(RadiusOfFirstSphere(folder, {"r=5"}), 5);
}

TEST(Scn, TheScenesOfTheCourseAreReadWithoutAnError) {
  const std::filesystem::path scenes = project::Root() / "../shared/scenes-cos426";
  if (!std::filesystem::exists(scenes)) GTEST_SKIP() << "no course scenes at " << scenes;
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes)) {
    if (entry.path().extension() != ".scn") continue;
    ++count;
    try {
      const ParsedScene parsed = Parse(entry.path(), {});
      EXPECT_FALSE(parsed.scene.root.children.empty()) << entry.path();
    } catch (const SceneErrors& errors) {
      ADD_FAILURE() << errors.what();
    }
  }
  EXPECT_GT(count, 40);
}

}  // namespace
}  // namespace ray

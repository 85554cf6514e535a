#include "source/app/report/Check.h"

#include <gtest/gtest.h>

#include <map>

#include "source/app/files/SceneHash.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Has;
using testing::TemporaryFolder;
using testing::WriteFile;

/// A flattened scene, from its text.
class Example {
 public:
  /// `files`: others in its folder, by name.
  explicit Example(const std::string& text, const std::map<std::string, std::string>& files = {})
      : parsed_(Parse(Written(text, files), {})), world_(parsed_.scene) {}

  const World& TheWorld() const { return world_; }
  /// Returns the likely mistakes, one per line.
  std::string Mistakes(const RenderSettings& settings = {}) const {
    std::string all;
    for (const std::string& mistake : LikelyMistakes(world_, settings)) all += mistake + "\n";
    return all;
  }

 private:
  std::string Written(const std::string& text, const std::map<std::string, std::string>& files) {
    for (const auto& [name, bytes] : files) WriteFile(folder_ / name, bytes);
    return WriteFile(folder_ / "example.scn", text);
  }

  TemporaryFolder folder_;
  ParsedScene parsed_;
  World world_;
};

const std::string camera = "camera 0 0 9  0 0 -1  0 1 0  0.4  0.1 100\n";

TEST(Check, AGoodSceneHasNoMistakes) { EXPECT_EQ(Example(camera + "sphere -1  0 0 0  1\n").Mistakes(), ""); }

TEST(Check, ASpecularMapWithoutEffectIsReported) {
  const std::map<std::string, std::string> files{{"t.ppm", "P3 1 1 255 255 255 255 "}};
  const auto mistakes = [&](const std::string& ks, const std::string& shape) {
    return Example(camera + "material 0 0 0  1 1 1  " + ks + "  0 0 0  0 0 0  10 1 0\nspecular_map 0 t.ppm\n" + shape,
                   files)
        .Mistakes();
  };
  const std::string sphere = "sphere 0  0 0 0  1\n", polygon = "polygon 0 3  0 0 0  1 0 0  0 1 0\n";
  EXPECT_EQ(mistakes("1 1 1", sphere), "");
  EXPECT_TRUE(
      Has(mistakes("0 0 0", sphere), ":4:1: warning: this shape has a specular map but neither ks nor a mirror"));
  EXPECT_EQ(mistakes("0 0 0", "mirror 0 1 0 0\n" + sphere), "");
  EXPECT_TRUE(Has(mistakes("1 1 1", polygon), "this shape has a specular map but no texture coordinates"));
}

TEST(Check, AProjectedTextureNeedsNoTextureCoordinates) {
  const std::map<std::string, std::string> files{{"t.ppm", "P3 1 1 255 255 255 255 "}};
  const auto mistakes = [&](const std::string& more) {
    return Example(camera + "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  10 1 t.ppm\n" + more +
                       "polygon 0 3  0 0 0  1 0 0  0 1 0\n",
                   files)
        .Mistakes();
  };
  EXPECT_TRUE(Has(mistakes(""), "this shape has a texture but no texture coordinates"));
  EXPECT_EQ(mistakes("texture_project 0\n"), "");
}

TEST(Check, ACameraInsideASolidIsReported) {
  for (const char* shape :
       {"sphere -1  0 0 9  1", "box -1  -5 -5 -5  5 5 10", "cylinder -1  0 0 9  1 4", "cone -1  0 0 9  3 8"})
    EXPECT_TRUE(Has(Example(camera + shape + "\n").Mistakes(), "the camera is inside 1 shape")) << shape;
  EXPECT_TRUE(Has(Example(camera + "sphere -1  0 0 9  1\nsphere -1  0 0 8 3\n").Mistakes(), "inside 2 shapes"));
}

TEST(Check, AnEmissiveSolidThatLightsNothingIsReported) {
  const std::string emissive = camera + "material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  10 1 0\n";
  const std::string warning = "this shape emits but lights nothing in mode whitted; -mode path makes it a light";
  const Example sphere(emissive + "sphere 0  0 0 0  1\n");
  EXPECT_TRUE(Has(sphere.Mistakes(), ":3:1: warning: " + warning));
  EXPECT_EQ(Example(emissive + "tri 0  0 0 0  1 0 0  0 1 0\n").Mistakes(), "");
  RenderSettings path, lit;
  path.mode = RenderMode::path;
  lit.trace.emissive_solids_light = true;
  EXPECT_EQ(sphere.Mistakes(path) + sphere.Mistakes(lit), "");
  path.trace.emission = Emission::color;
  EXPECT_TRUE(Has(sphere.Mistakes(path),
                  ":3:1: warning: this shape emits but lights nothing with -emission color; -emissive_solids on makes "
                  "it a light"));
}

TEST(Check, InsideTheBoundsIsNotInsideTheSolid) {
  const Example example(camera + "sphere -1  0.9 0.9 9.9  1.5\n");  // a corner of its box contains the camera
  EXPECT_EQ(SolidsAround(example.TheWorld(), {0, 0, 9}), 0);
  EXPECT_EQ(SolidsAround(example.TheWorld(), {0.9, 0.9, 9.9}), 1);
}

TEST(Check, BeingInsideFollowsTheTransformsOfTheGraph) {
  const Example example(camera + "begin -1  2 0 0 5  0 2 0 0  0 0 2 0  0 0 0 1\nsphere -1  0 0 0  1\nend\n");
  EXPECT_EQ(SolidsAround(example.TheWorld(), {6.5, 0, 0}), 1);
  EXPECT_EQ(SolidsAround(example.TheWorld(), {0.5, 0, 0}), 0);
}

// Whether a point is inside a sphere is computed without rays.
TEST(Check, InsideASphereIsNearerThanItsRadius) {
  const Example example(camera + "sphere -1  0.25 -0.5 0.125  1\n");
  for (int i = 0; i < 1000; ++i) {
    const R3::Point p{-1.3 + 0.26 * (i % 10) + 0.01, -1.3 + 0.26 * (i / 10 % 10) + 0.02,
                      -1.3 + 0.26 * (i / 100) + 0.03};
    const R3::Vector d = p - R3::Point{0.25, -0.5, 0.125};
    EXPECT_EQ(SolidsAround(example.TheWorld(), p), Dot(d, d) < 1 ? 1 : 0) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(Check, ASceneInTheDarkIsReported) {
  const std::string black = camera + "sphere -1  0 0 0  1\npoint_light 0 0 0  0 5 0  1 0 0\n";
  EXPECT_TRUE(Has(Example(black).Mistakes(), "the scene is unlit; every light is black"));
  const std::string glowing = "material 0 0 0  1 1 1  0 0 0  0 0 0  1 1 1  1 1 0\n";
  EXPECT_FALSE(Has(Example(glowing + black + "sphere 0  1 0 0  1\n").Mistakes(), "no light"));
}

RenderSettings Of(RenderMode mode) {
  RenderSettings settings;
  settings.mode = mode;
  return settings;
}

TEST(Check, AFlareWithoutALightIsReported) {
  const std::string warning = "-flare has no effect without a light; emissive surfaces have no lens flare";
  const std::string lamp = "material 0 0 0  0 0 0  0 0 0  0 0 0  9 9 9  1 1 0\nsphere 0  0 0 0  1\n";
  RenderSettings settings = Of(RenderMode::path);
  settings.flare = 1;
  EXPECT_TRUE(Has(Example(camera + lamp).Mistakes(settings), warning));
  EXPECT_FALSE(Has(Example(camera + lamp + "point_light 1 1 1  0 5 0  1 0 0\n").Mistakes(settings), warning));
  EXPECT_FALSE(Has(Example(camera + lamp).Mistakes(Of(RenderMode::path)), warning));
  settings.mode = RenderMode::depth;
  EXPECT_FALSE(Has(Example(camera + lamp).Mistakes(settings), warning)) << "which shows no light anyway";
}

TEST(Check, ADarkSceneIsNoMistakeInUnlitModes) {
  const Example dark(camera + "sphere -1  0 0 0  1\npoint_light 0 0 0  0 5 0  1 0 0\n");
  for (const RenderMode mode : {RenderMode::whitted, RenderMode::path, RenderMode::gooch, RenderMode::toon})
    EXPECT_TRUE(Has(dark.Mistakes(Of(mode)), "the scene is unlit")) << static_cast<int>(mode);
  for (const RenderMode mode : {RenderMode::flat, RenderMode::zbuffer, RenderMode::normal, RenderMode::uv})
    EXPECT_EQ(dark.Mistakes(Of(mode)), "") << static_cast<int>(mode);
}

// {color: [1, 0, 0]} without ka, kd and ks, in the languages with separate colors.
TEST(Check, AColorThatNoWeightUsesIsReported) {
  const std::string black = "material 0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  1 1 0\nflat_color 0  1 0 0\n";
  const Example example(camera + black + "sphere 0  0 0 0  1\n");
  EXPECT_TRUE(Has(example.Mistakes(), "has a color but no ka, kd or ks, and is black")) << example.Mistakes();
  EXPECT_EQ(example.Mistakes(Of(RenderMode::flat)), "");
  const std::string red = "material 0 0 0  1 0 0  0 0 0  0 0 0  0 0 0  1 1 0\nflat_color 0  1 0 0\n";
  EXPECT_EQ(Example(camera + red + "sphere 0  0 0 0  1\n").Mistakes(), "");
}

TEST(Check, TheCameraMayBeInsideGlass) {
  const std::string glass = "material 0 0 0  0 0 0  0 0 0  .9 .9 .9  0 0 0  1 1.5 0\n";
  EXPECT_EQ(Example(camera + glass + "sphere 0  0 0 9  1\n").Mistakes(), "");
}

// Regression: its box was taken from its file without the transform of its group.
TEST(Check, AMeshThatAGroupMovesIntoViewIsSeen) {
  const std::map<std::string, std::string> files{{"a.obj", "v 49 0 0\nv 51 0 0\nv 50 1 0\nf 1 2 3\n"}};
  const auto placed = [](const std::string& x) {
    return camera + "begin -1  1 0 0 " + x + "  0 1 0 0  0 0 1 0  0 0 0 1\nmesh -1 a.obj\nend\n";
  };
  EXPECT_EQ(Example(placed("-50"), files).Mistakes(), "");
  EXPECT_TRUE(Has(Example(placed("50"), files).Mistakes(), "this shape lies outside the view"));
}

TEST(Check, ASceneWithNothingInViewIsReported) {
  const std::string warning = "warning: nothing in the scene is in view of the camera";
  EXPECT_TRUE(Has(Example(camera + "sphere -1  0 0 20  1\n").Mistakes(), warning));
  EXPECT_FALSE(Has(Example(camera + "sphere -1  0 0 20  1\nsphere -1  0 0 0  1\n").Mistakes(), warning));
}

// One shape of many may be out of view on purpose, but not all of them.
TEST(Check, EveryRenderWarnsOfMistakesThatAreCheapToFind) {
  const auto plain = [](const std::string& text) {
    std::string all;
    for (const std::string& mistake : PlainMistakes(Example(camera + text).TheWorld(), {})) all += mistake + "\n";
    return all;
  };
  EXPECT_EQ(plain("sphere -1  0 0 0  1\nsphere -1  0 0 20  1\n"), "");
  EXPECT_TRUE(Has(plain("sphere -1  0 0 20  1\n"), "nothing in the scene is in view"));
  EXPECT_TRUE(Has(plain("sphere -1  0 0 9  1\n"), "the camera is inside 1 shape"));
  EXPECT_TRUE(Has(plain("sphere -1  0 0 0  1\npoint_light 0 0 0  0 5 0  1 0 0\n"), "the scene is unlit"));
  EXPECT_FALSE(Has(plain("sphere -1  0 0 0  0\n"), "degenerate")) << "its reader has said so";
}

// A render prints the findings of -check that spoil an image.
TEST(Check, EveryRenderHintsAtLampsCoincidentSurfacesAndEnclosedLights) {
  const auto hints = [](const std::string& text, const RenderSettings& settings = {}) {
    const Example example(camera + text);
    std::string all;
    const auto accelerator = FindAcceleratorKind("auto")->Make(example.TheWorld(), {});
    for (const std::string& hint : RenderHints(example.TheWorld(), *accelerator, settings)) all += hint + "\n";
    return all;
  };
  const std::string white = "material .1 .1 .1  .5 .5 .5  0 0 0  0 0 0  0 0 0  1 1 0\n",
                    glowing = "material 0 0 0  0 0 0  0 0 0  0 0 0  3 3 3  1 1 0\n",
                    floor = "quad 0 -9 -1 -9  9 -1 -9  9 -1 9  -9 -1 9\n",
                    lamp = "quad 1 -.1 3 -.1  .1 3 -.1  .1 3 .1  -.1 3 .1\n";
  const std::string room = hints(white + glowing + floor + lamp);
  EXPECT_TRUE(Has(room, "example.scn:5:1: warning: the scene has no lights: in mode whitted two default lights"))
      << room;
  EXPECT_EQ(hints(white + glowing + floor + lamp, Of(RenderMode::path)), "");
  RenderSettings solids;
  solids.trace.emissive_solids_light = true;
  EXPECT_FALSE(Has(hints(white + glowing + floor + lamp, solids), "default lights"));
  EXPECT_TRUE(Has(hints(white + glowing + floor + "point_light 1 1 1  0 3 0  1 0 0 sphere 0 0 3 0 .5"),
                  "is inside a shape that no light leaves"));
  // A lamp in the plane of a ceiling, out of the camera's view.
  const std::string behind = "quad 0 -9 3 30  9 3 30  9 3 50  -9 3 50\nquad 1 -1 3 39  1 3 39  1 3 41  -1 3 41\n";
  EXPECT_TRUE(Has(hints(white + glowing + floor + behind, Of(RenderMode::path)),
                  "example.scn:5:1: warning: this shape lies in one plane"));
}

TEST(Check, ReportsTheDefaultsThatApply) {
  const std::string none = SceneSummary(Example("sphere -1  0 0 0  1\n").TheWorld(), {});
  EXPECT_TRUE(Has(none, " degrees in all (the default: the scene names none)\n")) << none;
  EXPECT_TRUE(Has(none, "lights        2 (the default: the scene names none)\n")) << none;
  EXPECT_FALSE(Has(SceneSummary(Example(camera + "point_light 1 1 1  0 5 0  1 0 0\n").TheWorld(), {}), "default"));
}

TEST(Check, EmissiveShapesReplaceDefaultLightsInModePath) {
  const std::string lamp = "material 0 0 0  0 0 0  0 0 0  0 0 0  3 3 3  1 1 0\nsphere 0  0 0 0  1\n";
  const Example example(camera + lamp);
  const std::string path = SceneSummary(example.TheWorld(), Of(RenderMode::path));
  EXPECT_TRUE(Has(path, "lights        0 (the scene has none; emissive surfaces light it)\n")) << path;
  const std::string whitted = SceneSummary(example.TheWorld(), Of(RenderMode::whitted));
  EXPECT_TRUE(Has(whitted, "lights        2 (the default: the scene names none), and 1 shape that emits\n")) << whitted;
}

TEST(Check, AnEmptySceneIsReported) { EXPECT_TRUE(Has(Example("").Mistakes(), "nothing in the scene")); }

TEST(Check, TheWallBehindTheCameraIsNoMistake) {
  const std::string room = "quad -1  -5 -1 12  5 -1 12  5 4 12  -5 4 12\nsphere -1 0 0 0 1\n";
  EXPECT_FALSE(Has(Example(camera + room).Mistakes(), "outside the view")) << Example(camera + room).Mistakes();
}

TEST(Check, AmbientLightLightsWhatReflectsIt) {
  const std::string dark = "ambient 1 1 1\npoint_light 0 0 0  0 5 0  1 0 0\n";
  const std::string black = "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0\nsphere 0  0 0 0  1\n";
  EXPECT_FALSE(Has(Example(camera + dark + "sphere -1  0 0 0  1\n").Mistakes(), "unlit"));
  EXPECT_TRUE(Has(Example(camera + dark + black).Mistakes(), "unlit"));
}

TEST(Check, ShapesOutsideTheViewAreCountedAtTheFirst) {
  const std::string mistakes =
      Example(camera + "sphere -1  0 0 0  1\nsphere -1  0 0 20  1\nsphere -1  90 0 0  1\n").Mistakes();
  EXPECT_TRUE(Has(mistakes, "example.scn:3:1: warning: this shape lies outside the view (and 1 more)")) << mistakes;
  EXPECT_FALSE(Has(mistakes, "example.scn:2"));
}

TEST(Check, TrianglesWoundAgainstTheirNormalsAreCountedAtTheFirst) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 2 1 0\nvn 0 0 1\n";
  const std::string right = "f 1//1 2//1 3//1\n", left = "f 4//1 6//1 5//1\n";
  const std::string scene = camera + "mesh -1 a.obj smooth\nmesh -1 a.obj smooth\n";
  const std::string mistakes = Example(scene, {{"a.obj", corners + right + left}}).Mistakes();
  EXPECT_TRUE(Has(mistakes,
                  "example.scn:2:1: warning: 1 triangle of 2 in this mesh is wound against the vertex normals, the "
                  "first on line 9 of its file; the normals decide which side is the front\n"))
      << mistakes;
  EXPECT_FALSE(Has(mistakes, "example.scn:3")) << "a mesh is reported once";
  EXPECT_EQ(Example(scene, {{"a.obj", corners + right}}).Mistakes(), "");
  EXPECT_EQ(Example(camera + "mesh -1 a.obj\n", {{"a.obj", corners + left}}).Mistakes(), "") << "flat";
}

TEST(Check, TheSummaryCountsTheContents) {
  const Example example(camera +
                        "sphere -1  0 0 0  1\nbegin -1  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\nbox -1 0 0 0 1 1 1\nend\n");
  const std::string summary = SceneSummary(example.TheWorld(), {});
  EXPECT_TRUE(Has(summary, "shapes        2\n")) << summary;
  EXPECT_TRUE(Has(summary, "bounds        -1.000 -1.000 -1.000  to  1.000 1.000 1.000\n")) << summary;
  EXPECT_TRUE(Has(summary, "camera        at 0.000 0.000 9.000")) << summary;
}

TEST(Check, PositionsInASmallSceneHaveMoreDecimals) {
  const std::string summary = SceneSummary(Example("sphere -1  0 0 0  .0001\n").TheWorld(), {});
  EXPECT_TRUE(Has(summary, "bounds        -0.0001000 -0.0001000 -0.0001000  to  0.0001000")) << summary;
}

// The published test vectors of the hash, so that another program can check an image's scene.
TEST(SceneHash, IsFnv1a64) {
  const TemporaryFolder folder;
  EXPECT_EQ(SceneHash(std::vector{WriteFile(folder / "empty", "")}), "cbf29ce484222325");
  EXPECT_EQ(SceneHash(std::vector{WriteFile(folder / "a", "a")}), "af63dc4c8601ec8c");
  EXPECT_EQ(SceneHash(std::vector{WriteFile(folder / "foobar", "foobar")}), "85944171f73967e8");
}

TEST(SceneHash, CoversAllFilesAndEveryByte) {
  const TemporaryFolder folder;
  const std::string foo = WriteFile(folder / "foo", "foo"), bar = WriteFile(folder / "bar", "bar");
  EXPECT_EQ(SceneHash(std::vector{foo, bar}), "85944171f73967e8");
  WriteFile(folder / "long", std::string(65536, 'x'));
  const std::string before = SceneHash(std::vector{folder / "long"});
  WriteFile(folder / "long", std::string(65535, 'x') + "y");
  EXPECT_NE(SceneHash(std::vector{folder / "long"}), before);
}

TEST(Check, ColorsInBytesAreReported) {
  const auto mistakes = [](const std::string& kd) {
    return Example(camera + "material 0 0 0  " + kd + "  0 0 0  0 0 0  0 0 0  10 1 0\nsphere 0  0 0 0  1\n").Mistakes();
  };
  EXPECT_TRUE(Has(mistakes("255 128 0"), ":3:1: warning: this shape reflects more than 16 times the light"));
  EXPECT_TRUE(Has(mistakes("0 0 40"), "kd is from 0 to 1, not from 0 to 255"));
  EXPECT_EQ(mistakes("1.5 1 1"), "");
}

}  // namespace
}  // namespace ray

#include "source/app/report/Questions.h"

#include <gtest/gtest.h>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Has;
using testing::TemporaryFolder;
using testing::WriteFile;

RenderSettings InMode(RenderMode mode) {
  RenderSettings settings;
  settings.mode = mode;
  return settings;
}
const RenderSettings whitted = InMode(RenderMode::whitted), path = InMode(RenderMode::path);

/// Returns the findings about a scene, one per line.
std::string SaidOf(const std::string& text, const RenderSettings& settings) {
  const project::Stage stage(project::FromText(text));
  std::string all;
  for (const std::string& mistake : LampMistakes({stage.world, settings})) all += mistake + "\n";
  return all;
}

/// No light except lamps; material 0 emits 3, material 1 is white.
const std::string lamps_alone =
    "point_light 0 0 0  0 9 0  1 0 0 material 0 0 0  0 0 0  0 0 0  0 0 0  3 3 3  1 1 0 "
    "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 0 ";
const std::string grain = "sphere 1  0 0 0  1e-3 ";  // a surface to be lit
const std::string half_a_unit = "tri 0  0 10 0  1 10 0  0 10 1 ";

TEST(LampCheck, ModePathWeakensLampsByTheirSolidAngle) {
  // A / (pi d^2), a tenth of a percent less since the corners are farther away.
  const std::string said =
      "scene.scn:1:155: warning: lamps light the scene about 630 times as strongly in mode whitted, "
      "where each has its full color at any size and distance, as in mode path, where "
      "emission is a radiance; -emission color makes mode path agree with whitted\n";
  for (const RenderSettings& settings : {whitted, path}) {
    const std::string found = SaidOf(lamps_alone + grain + half_a_unit, settings);
    EXPECT_TRUE(Has(found, said)) << found;
  }
  EXPECT_TRUE(
      Has(SaidOf(lamps_alone + grain + "tri 0  0 1e6 0  1 1e6 0  0 1e6 1", path), " more than a million times"));
}

// A sphere that appears as large as a cone of half angle a shows a surface 2 (1 - cos a) of its radiance.
TEST(LampCheck, TheModesDifferIfTheFactorIsTwoOrMore) {
  for (const double factor : {1.5, 1.98, 2.02, 3.}) {
    const double cosine = 1 - 1 / (2 * factor), radius = 10 * std::sqrt(1 - cosine * cosine);
    for (RenderSettings settings : {whitted, path}) {
      settings.trace.emissive_solids_light = true;
      const std::string found =
          SaidOf(lamps_alone + grain + "sphere 0  0 10 0  " + std::to_string(radius), settings);
      EXPECT_EQ(Has(found, "lamps light the scene about "), factor > 2) << factor << found;
      const std::string sun = "dir_light 2.5 2.5 2.5  0 -1 0 ";
      EXPECT_EQ(SaidOf(sun + lamps_alone + grain + "sphere 0  0 10 0  " + std::to_string(radius), settings), "")
          << "the light of both is less than twice as strong";
    }
  }
}

TEST(LampCheck, IsSilentWhereOtherLightDominatesOrEmissionIsColor) {
  for (const char* light : {"dir_light 4 4 4  0 -1 0", "ambient 4 4 4", "point_light 500 500 500  0 -10 0  1 1 1"})
    for (const RenderSettings& settings : {whitted, path})
      EXPECT_EQ(SaidOf(lamps_alone + grain + half_a_unit + light, settings), "") << light;
  EXPECT_NE(SaidOf(lamps_alone + grain + half_a_unit + "dir_light 2 2 2  0 -1 0", whitted), "");
  for (RenderSettings settings : {whitted, path}) {
    settings.trace.emission = Emission::color;
    EXPECT_EQ(SaidOf(lamps_alone + grain + half_a_unit, settings), "");
  }
  for (const RenderMode mode : {RenderMode::flat, RenderMode::normal, RenderMode::gooch})
    EXPECT_EQ(SaidOf(lamps_alone + grain + half_a_unit, InMode(mode)), "");
}

TEST(LampCheck, WithoutSurfacesToLightNothingIsReported) {
  const std::string glass = "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  1 1.5 0 sphere 2  0 0 0  1 ";
  for (const RenderSettings& settings : {whitted, path}) {
    EXPECT_EQ(SaidOf(lamps_alone + half_a_unit, settings), "");
    EXPECT_EQ(SaidOf(lamps_alone + half_a_unit + glass, settings), "");
    const std::string white_lamp = "material 0 0 0  1 1 1  0 0 0  0 0 0  1 1 1  1 1 0 sphere 2  0 0 0  1";
    EXPECT_EQ(SaidOf(lamps_alone + white_lamp, settings), "") << "it is alone";
    EXPECT_NE(SaidOf(lamps_alone + half_a_unit + "plane 1  0 0 0  0 1 0", settings), "");
  }
}

TEST(LampCheck, SolidsThatLightInModePathOnlyAreReported) {
  const std::string lamp = "sphere 0  0 2 0  1 ";
  EXPECT_TRUE(Has(SaidOf(lamps_alone + grain + lamp, path),
                  "emissive solids light the scene in mode path only; with -emissive_solids on they do in mode "
                  "whitted, too"));
  EXPECT_EQ(SaidOf(lamps_alone + grain + lamp, whitted), "") << "each is pointed out in that mode";
  EXPECT_EQ(SaidOf(lamps_alone + grain + lamp + "background 2 2 2", path), "") << "which lights more than the lamp";
  EXPECT_TRUE(Has(SaidOf(lamps_alone + grain + "plane 0  0 5 0  0 1 0", path), "in mode path only"));
  // A triangle of a tenth of the radiance lights in both modes.
  EXPECT_TRUE(Has(SaidOf(lamps_alone + grain + lamp +
                             "material 0 0 0  0 0 0  0 0 0  0 0 0  .3 .3 .3  1 1 0 tri 2  0 10 0  1 10 0  0 10 1",
                         path),
                  " times as strongly in mode path, where every emissive surface is a lamp, as in mode whitted"));
}

TEST(LampCheck, ABackgroundInModePathIsNotTakenForLamps) {
  const std::string wide_lamp = "tri 0  -1e4 1 -1e4  1e4 1 -1e4  0 1 1e4 ";
  const std::string faint_plane = "material 0 0 0  0 0 0  0 0 0  0 0 0  .6 .6 .6  1 1 0 plane 2  0 -1 0  0 1 0 ";
  EXPECT_EQ(SaidOf(lamps_alone + grain + wide_lamp + faint_plane + "background 3.5 3.5 3.5", path), "");
}

TEST(LampCheck, DefaultLightsThatShineInModeWhittedOnlyAreReported) {
  const std::string no_light = lamps_alone.substr(lamps_alone.find("material"));
  for (const RenderSettings& settings : {whitted, path}) {
    const std::string found = SaidOf(no_light + grain + "sphere 0  0 10 0  1", settings);
    EXPECT_TRUE(Has(found, "the scene has no lights: in mode whitted two default lights make it about "))
        << found;
  }
}

TEST(LampCheck, AMeshOfManyLampsIsReported) {
  const TemporaryFolder folder;
  WriteFile(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\n");
  const std::string text = "dir_light 1e6 1e6 1e6  0 -1 0\nmaterial 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  1 1 0\n";
  const auto said = [&](const std::string& shapes, const RenderSettings& settings) {
    const project::Stage stage(Parse(WriteFile(folder / "a.scn", text + shapes), {}).scene);
    const auto mistakes = LampMistakes({stage.world, settings});
    return mistakes.empty() ? "" : mistakes[0];
  };
  const std::string meshes = "mesh 0 a.obj\nbegin -1  1 0 0 3  0 1 0 0  0 0 1 0  0 0 0 1 mesh 0 a.obj end\n";
  RenderSettings colored = path, whole = whitted;
  colored.trace.emission = Emission::color;
  whole.trace.emissive_meshes = EmissiveMeshes::whole;
  for (const RenderSettings& settings : {whitted, colored})
    EXPECT_TRUE(Has(said(meshes, settings),
                    "a.scn:3:1: warning: each of the 3 triangles of this mesh is a lamp, and all together light up to "
                    "3 times as strongly as one: a finer mesh would be brighter; -emissive_meshes whole makes the mesh "
                    "one lamp (and 1 more)"))
        << said(meshes, settings);
  EXPECT_EQ(said(meshes, path), "") << "there a finer mesh is as bright";
  EXPECT_EQ(said(meshes, whole), "");
  EXPECT_EQ(said("mesh -1 a.obj", whitted), "");
  EXPECT_EQ(said("quad 0  0 0 0  1 0 0  1 1 0  0 1 0 tri 0  0 0 0  1 0 0  1 1 0", whitted), "");
}

}  // namespace
}  // namespace ray

#include "source/app/report/Questions.h"

#include <gtest/gtest.h>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Has;
using testing::TemporaryFolder;
using testing::WriteFile;

const std::string matte = "material 0 0 0  .5 .5 .5  0 0 0  0 0 0  0 0 0  10 1 0\n",
                  clear_glass = "material 0 0 0  0 0 0  .1 .1 .1  .9 .9 .9  0 0 0  10 1.5 0\n",
                  water = "material 0 0 0  0 0 0  .1 .1 .1  .9 .9 .9  0 0 0  10 1.33 0\n";

/// Returns the likely mistakes, one per line.
std::string Mistakes(const std::string& text, const std::string& mesh = "") {
  const TemporaryFolder folder;
  if (!mesh.empty()) WriteFile(folder / "mesh.off", mesh);
  const std::string file = WriteFile(folder / "example.scn", "camera 0 0 9  0 0 -1  0 1 0  .3 .01 99\n" + text);
  const ParsedScene parsed = Parse(file, {});
  const World world(parsed.scene);
  std::string all;
  for (const std::string& mistake : ContactMistakes({world, RenderSettings()})) all += mistake + "\n";
  return all;
}

TEST(ContactCheck, ReportsSurfacesOfDifferentMaterialsInOnePlane) {
  const std::string wall = "quad 0 -1 -1 0  1 -1 0  1 1 0  -1 1 0\n",
                    poster = "quad 1 -.5 -.5 0  .5 -.5 0  .5 .5 0  -.5 .5 0\n";
  EXPECT_TRUE(Has(Mistakes(matte + matte + wall + poster),
                  "example.scn:5:1: warning: this shape lies in one plane with that of "));
  const std::string glowing = "material 0 0 0  0 0 0  0 0 0  0 0 0  3 3 3  1 1 0\n";
  const std::string found = Mistakes(matte + glowing + wall + poster);
  EXPECT_TRUE(Has(found, "example.scn:4:1: warning: this shape lies in one plane with that of ")) << found;
  EXPECT_TRUE(Has(found, "example.scn:5:1, which emits and hides it")) << found;
  EXPECT_EQ(Mistakes(matte + matte + wall + "quad 0 -.5 -.5 0  .5 -.5 0  .5 .5 0  -.5 .5 0\n"), "");
  EXPECT_EQ(Mistakes(matte + matte + wall + "quad 1 -.5 -.5 1e-3  .5 -.5 1e-3  .5 .5 1e-3  -.5 .5 1e-3\n"), "");
}

TEST(ContactCheck, ReportsTheSameShapeOfAnotherMaterial) {
  const std::string two_balls = "sphere 0 0 0 0 1\nsphere 1 0 0 0 1\n";
  EXPECT_TRUE(Has(Mistakes(matte + matte + two_balls), "example.scn:5:1: warning: this shape is the same as that of "));
  EXPECT_EQ(Mistakes(matte + "sphere 0 0 0 0 1\nsphere 0 0 0 0 1\n"), "");
  const std::string glowing = "material 0 0 0  0 0 0  0 0 0  0 0 0  3 3 3  1 1 0\n";
  EXPECT_TRUE(
      Has(Mistakes(matte + glowing + two_balls), "example.scn:4:1: warning: this shape is the same as that of "));
}

TEST(ContactCheck, AllowsGlassOnAFloor) {
  EXPECT_EQ(Mistakes(matte + clear_glass + "quad 0 -1 -1 0  1 -1 0  1 1 0  -1 1 0 box 1 -.5 -.5 0  .5 .5 1\n"), "");
}

TEST(ContactCheck, ReportsALightThatNothingSees) {
  EXPECT_TRUE(Has(Mistakes(matte + "point_light 1 1 1  0 0 0  1 0 0 sphere 0 0 0 0 1\n"),
                  "inside a shape that no light leaves"));
  EXPECT_EQ(Mistakes(clear_glass + "point_light 1 1 1  0 0 0  1 0 0 sphere 0 0 0 0 1\n"), "");
  EXPECT_EQ(Mistakes(matte + "point_light 1 1 1  0 0 0  1 0 0 sphere 0 0 0 0 50\n"), "");  // around the camera, too
}

TEST(ContactCheck, ReportsALightInAClosedMesh) {
  const std::string tetrahedron =
                        "OFF\n4 4 6\n-1 -1 -1\n3 -1 -1\n-1 3 -1\n-1 -1 3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
                    scene = matte + "point_light 1 1 1  0 0 0  1 0 0 mesh 0 mesh.off\n";
  EXPECT_TRUE(Has(Mistakes(scene, tetrahedron), "inside a shape that no light leaves"));
  EXPECT_EQ(Mistakes(scene, "OFF\n4 3 6\n-1 -1 -1\n3 -1 -1\n-1 3 -1\n-1 -1 3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"), "");
}

TEST(ContactCheck, ReportsGlassWithHoles) {
  const std::string tetrahedron = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
                    scene = clear_glass + "mesh 0 mesh.off\n";
  EXPECT_EQ(Mistakes(scene, tetrahedron), "");
  std::string open = tetrahedron;
  open.replace(open.find("3 1 2 3"), 7, "3 0 2 1");
  EXPECT_TRUE(Has(Mistakes(scene, open), "is not closed"));
}

TEST(ContactCheck, ReportsGlassOfOneSide) {
  EXPECT_TRUE(Has(Mistakes(clear_glass + "one_sided 0 sphere 0 0 0 0 1\n"), "one-sided"));
  EXPECT_EQ(Mistakes(matte + "one_sided 0 sphere 0 0 0 0 1\n"), "");
}

TEST(ContactCheck, ReportsSolidsThatOverlapWithOnePriority) {
  const std::string solids = "box 0 -1 -1 -1  1 1 1 sphere 1 0 0 0 .5\n";
  EXPECT_TRUE(Has(Mistakes(clear_glass + water + solids), "have the same priority"));
  EXPECT_EQ(Mistakes(clear_glass + water + solids + "priority 1 1\n"), "");
  EXPECT_EQ(Mistakes(clear_glass + water + "box 0 -1 -1 -1  1 1 1 sphere 1 1.5 0 0 .5\n"), "");  // they touch
}

TEST(ContactCheck, ReportsASolidThatAHigherPriorityHides) {
  const std::string solids = "box 0 -1 -1 -1  1 1 1\nsphere 1 0 0 0 .5\n";
  EXPECT_TRUE(Has(Mistakes(clear_glass + water + solids + "priority 0 1\n"),
                  "example.scn:5:1: warning: this solid lies inside that of "));
  EXPECT_EQ(Mistakes(clear_glass + water + "box 0 -1 -1 -1  1 1 1 sphere 1 .9 0 0 .5\npriority 0 1\n"), "");
}

}  // namespace
}  // namespace ray

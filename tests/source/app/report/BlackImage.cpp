#include "source/app/report/BlackImage.h"

#include <gtest/gtest.h>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Has;

const std::string white_wall = "material 0 0 0  .8 .8 .8  0 0 0  0 0 0  0 0 0  1 1 0 ",
                  lamp_within = "point_light 1 1 1  0 0 0  1 0 0 ",
                  eye_outside = "camera 0 0 9  0 0 -1  0 1 0  .3 .01 100 ",
                  walls =
                      "quad 0 -2 -2 2  2 -2 2  2 2 2  -2 2 2  quad 0 -2 -2 -2  2 -2 -2  2 2 -2  -2 2 -2 "
                      "quad 0 -2 -2 -2  -2 -2 2  -2 2 2  -2 2 -2  quad 0 2 -2 -2  2 -2 2  2 2 2  2 2 -2 "
                      "quad 0 -2 -2 -2  2 -2 -2  2 -2 2  -2 -2 2  quad 0 -2 2 -2  2 2 -2  2 2 2  -2 2 2 ";

/// Returns the reason that is printed, or "lit" if the image is not black.
std::string Reason(const std::string& text, RenderMode mode = RenderMode::whitted) {
  const project::Stage stage(project::FromText(text));
  RenderSettings settings;
  settings.mode = mode;
  settings.width = 40, settings.height = 30;
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  if (!IsWhollyBlack(Render(stage.world, *accelerator, settings).image)) return "lit";
  return WhyBlack(stage.world, *accelerator, settings);
}

TEST(BlackImage, TheEyeOutsideOfAClosedRoomIsNamed) {
  EXPECT_TRUE(Has(Reason(eye_outside + white_wall + lamp_within + walls), "outside of a closed room"));
  EXPECT_TRUE(
      Has(Reason(eye_outside + white_wall + lamp_within + "box 0 -2 -2 -2  2 2 2"), "outside of a closed room"));
  EXPECT_EQ(Reason("camera 0 0 1.9  0 0 -1  0 1 0  .3 .01 100 " + white_wall + lamp_within + walls), "lit");
}

TEST(BlackImage, ALampThatNothingInViewSeesIsNamed) {
  const std::string floor = "quad 0 -9 -2 -9  9 -2 -9  9 -2 9  -9 -2 9 ", above = "point_light 1 1 1  0 9 0  1 0 0 ",
                    eye = "camera 0 0 0  0 -1 0  0 0 1  .3 .01 100 ";
  EXPECT_TRUE(Has(Reason(eye + white_wall + above + floor + "quad 0 -9 4 -9  9 4 -9  9 4 9  -9 4 9"), "is in shadow"));
  EXPECT_EQ(Reason(eye + white_wall + above + floor), "lit");
  EXPECT_TRUE(
      Has(Reason(eye + white_wall + "point_light 1 1 1  0 -9 0  1 0 0 " + floor), "from behind, and the lights"));
}

TEST(BlackImage, BackFacesAreNamed) {
  const std::string sun = "dir_light 1 1 1  0 0 -1 ", away = "tri 0 -2 -2 0  0 2 0  2 -2 0 ";
  EXPECT_TRUE(Has(Reason(eye_outside + white_wall + "one_sided 0 " + sun + away), "one-sided and turned away"));
  EXPECT_EQ(Reason(eye_outside + white_wall + "one_sided 0 " + sun + "tri 0 -2 -2 0  2 -2 0  0 2 0 "), "lit");
}

TEST(BlackImage, NothingInViewAndBlackSurfacesAreNamed) {
  const std::string sun = "dir_light 1 1 1  0 0 -1 ";
  EXPECT_TRUE(Has(Reason(eye_outside + white_wall + sun + "sphere 0 0 0 20 1"), "nothing but the background"));
  EXPECT_TRUE(Has(Reason(eye_outside + sun + "material 0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  1 1 0 sphere 0 0 0 0 1"),
                  "kd, ks, kr and kt are 0"));
}

TEST(BlackImage, TheProgramNamesTheReasonUnlessItIsQuiet) {
  NEEDS_THE_PROGRAM();
  const testing::TemporaryFolder folder;
  const std::string scene = testing::WriteFile(folder / "a.scn", eye_outside + white_wall + lamp_within + walls);
  const std::vector<std::string> words{scene, folder / "a.png", "-width", "16", "-height", "16"};
  const auto loud = testing::RunProgram(words), quiet = testing::RunProgram(testing::With(words, {"-quiet"}));
  EXPECT_EQ(loud.status, 0);
  EXPECT_TRUE(Has(loud.error, "warning: the image is black; there is light only behind")) << loud.error;
  EXPECT_EQ(quiet.error, "");
}

}  // namespace
}  // namespace ray

#include "source/app/report/Advice.h"

#include <gtest/gtest.h>

#include "source/accelerate/Accelerator.h"
#include "source/app/options/OptionTable.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Has;

const std::string camera_above = "camera 0 2 6  0 -.3 -1  0 1 0  .5  .1 100\n";
const std::string soft_light = "area_light 1 1 1  0 4 1  0 -1 0  1  1 0 0\n";
const std::string ball =
    "material 0 0 0  .8 .8 .8  0 0 0  0 0 0  0 0 0  1 1 0\nbox 0  -4 -.1 -4  4 0 4\nsphere 0  0 .8 0  .8\n";

std::string AdviceOn(const std::string& scene, const std::vector<std::string>& words = {}) {
  const testing::TemporaryFolder folder;
  const ParsedScene parsed = Parse(testing::WriteFile(folder / "example.scn", camera_above + scene), {});
  Options options = Defaults(Program::raypro);
  options.render.width = options.render.height = 48;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2)
    Store(*FindOption(Program::raypro, words[i]), std::vector{words[i + 1]}, options);
  const World world(parsed.scene);
  return Advice(world, *FindAcceleratorKind("bvh")->Make(world, {}), options.render);
}

TEST(Advice, OnlyKnobsThatTheSceneHasAreTried) {
  const std::string soft = AdviceOn(soft_light + ball);
  EXPECT_TRUE(Has(soft, "\n-shadow_samples 1 ")) << soft;
  EXPECT_FALSE(Has(soft, "-lights") || Has(soft, "-max_depth") || Has(soft, "-strategy")) << soft;
  const std::string path = AdviceOn(soft_light + soft_light + ball, {"mode", "path", "strategy", "light"});
  EXPECT_TRUE(Has(path, "\n-lights one ") && Has(path, "\n-strategy mis ") && Has(path, "\n-max_depth 6 ")) << path;
  EXPECT_FALSE(Has(path, "-shadow_samples") || Has(path, "-min_luminance")) << path;
  std::string lights;
  for (int i = 0; i < 5; ++i) lights += soft_light;
  const std::string many = AdviceOn(lights + ball, {"mode", "path"});
  EXPECT_TRUE(Has(many, "\n-lights all ")) << many;
}

TEST(Advice, LightThatDepthCutsAwayIsTold) {
  // A white room lit by a lamp within it is much brighter after many bounces.
  const std::string room =
      "material 0 0 0  .9 .9 .9  0 0 0  0 0 0  0 0 0  1 1 0\npoint_light 3 3 3  0 1 0  1 0 0\n"
      "box 0  -9 -9 -9  9 9 9\n";
  const std::string text = AdviceOn(room, {"mode", "path", "max_depth", "1"});
  EXPECT_TRUE(Has(text, "With -max_depth 2 the image has ")) << text;
  EXPECT_TRUE(Has(text, "% more light")) << text;
  EXPECT_FALSE(Has(AdviceOn(soft_light + ball), "more light"));
}

TEST(Advice, AnImageWithoutNoiseIsSaidToHaveNone) {
  EXPECT_TRUE(Has(AdviceOn("background .5 .5 .5\n"), "No noise was found"));
}

TEST(Advice, TheTargetIsTheErrorAskedForInItsUnit) {
  EXPECT_TRUE(Has(AdviceOn(soft_light + ball), " to 2/255\n"));
  const std::string relative = AdviceOn(soft_light + ball, {"error", "3%"});
  EXPECT_TRUE(Has(relative, " to 3%\n") && Has(relative, " lin ")) << relative;
  EXPECT_FALSE(Has(relative, "-error 2")) << relative;
}

}  // namespace
}  // namespace ray

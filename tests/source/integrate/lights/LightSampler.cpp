#include "source/integrate/lights/LightSampler.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/Project.h"
#include "tests/extremes/KnownScenes.h"

namespace ray {
namespace {

// Otherwise -debugpixel would show users the wrong light as the source of a bright spot.
TEST(LightSampler, NamesEachOfItsLightsByItsKind) {
  const project::Stage stage(
      project::FromText("point_light 1 1 1  1 2 3  1 0 0 dir_light 1 1 1  0 -1 0 "
                        "material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  10 1 0 "
                        "tri 0  0 0 0  1 0 0  0 1 0 tri 0  0 0 5  1 0 5  0 1 5 sphere 0  9 0 0  1 sphere 0  9 9 0  1"));
  const LightSampler lights(stage.world, {});
  std::vector<std::string> kinds;
  for (int i = 0; i < lights.Count(); ++i) {
    const std::string said = lights[i].Describe();
    kinds.push_back(said.substr(0, said.find(' ', said.find(' ') + 1)));
  }
  const std::vector<std::string> expected{"point light",        "directional light", "emissive triangle,",
                                          "emissive triangle,", "emissive shape,",   "emissive shape,"};
  EXPECT_EQ(kinds, expected);
}

TEST(LightSampler, DefaultLightsShineOnlyWhereNothingElseDoes) {
  const std::string lamp = "material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  10 1 0 sphere 0  0 0 0  1 ";
  const auto count = [](const project::Stage& stage) { return LightSampler(stage.world, {}).Count(); };
  EXPECT_EQ(count(project::Stage(project::FromText("sphere -1  0 0 0  1"))), 2);
  EXPECT_EQ(count(project::Stage(project::FromText(lamp))), 1) << "the lamp";
  EXPECT_EQ(count(project::Stage(project::FromText(lamp + "dir_light 1 1 1  0 -1 0"))), 2) << "a light that is named";
  EXPECT_EQ(count(statistics::StageOf("sphere -1  0 0 0  1 ", statistics::UniformSky(1))), 1) << "the sky";
}

}  // namespace
}  // namespace ray

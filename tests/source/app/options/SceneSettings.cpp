#include "source/app/options/SceneSettings.h"

#include <gtest/gtest.h>

#include "source/app/options/CommandLine.h"

namespace ray {
namespace {

Scene With(std::vector<SceneSetting> settings) {
  Scene scene;
  scene.settings = std::move(settings);
  return scene;
}

RenderOptions Typed(std::vector<std::string> words) {
  words.insert(words.begin(), {"in.scn", "out.png"});
  return ReadCommandLine(Program::raypro, words);
}

TEST(SceneSettings, ApplyUnlessTheCommandLineSetsThem) {
  const Scene scene = With({{"max_depth", "7", "a.scn:1:5"}, {"width", "40", "a.scn:2:5"}, {"motion", "0 1 2", "x"}});
  const RenderOptions silent = WithSettingsOf(scene, Typed({}));
  EXPECT_EQ(silent.render.trace.max_depth, 7);
  EXPECT_EQ(silent.render.width, 40);
  EXPECT_EQ(silent.render.camera.motion, (R3::Vector{0, 1, 2}));
  const RenderOptions typed = WithSettingsOf(scene, Typed({"-maxreflections", "3", "-width", "256"}));
  EXPECT_EQ(typed.render.trace.max_depth, 3);
  EXPECT_EQ(typed.render.width, 256);  // although it is the default
}

/// Width, height and samples, as a user reads them.
std::string ImageOf(const Scene& scene, const std::vector<std::string>& words) {
  const RenderSettings render = WithSettingsOf(scene, Typed(words)).render;
  return std::to_string(render.width) + "x" + std::to_string(render.height) + " " + std::to_string(render.samples);
}

TEST(SceneSettings, NeitherTheyNorTheCommandLineChooseTheDefaultImage) {
  const Scene scene;
  EXPECT_EQ(ImageOf(scene, {}), "1024x1024 16");
  EXPECT_EQ(ImageOf(scene, {"-mode", "path", "-seed", "3"}), "1024x1024 16");
  EXPECT_EQ(ImageOf(scene, {"-samples", "1"}), "1024x1024 1");
  EXPECT_EQ(ImageOf(scene, {"-error", "2"}), "1024x1024 1") << "as many samples as the error needs";
  EXPECT_EQ(ImageOf(scene, {"-quality", "draft"}), "1024x1024 4");
  EXPECT_EQ(ImageOf(scene, {"-width", "300"}), "300x256 1") << "the course's defaults";
  EXPECT_EQ(ImageOf(scene, {"-height", "300", "-samples", "9"}), "256x300 9");
  EXPECT_EQ(ImageOf(With({{"width", "40", "x"}}), {}), "40x256 1");
  EXPECT_EQ(ImageOf(With({{"samples", "3", "x"}}), {}), "1024x1024 3");
  EXPECT_EQ(ImageOf(With({{"samples", "3", "x"}}), {"-height", "50"}), "256x50 3");
}

TEST(SceneSettings, ARequestedPresetComesBeforeThem) {
  const Scene scene = With({{"max_depth", "7", "a.scn:1:5"}});
  EXPECT_EQ(WithSettingsOf(scene, Typed({"-quality", "draft"})).render.trace.max_depth, 20);
  const Scene of_filter = With({{"filter", "mitchell", "a.scn:1:5"}});
  EXPECT_EQ(WithSettingsOf(of_filter, Typed({"-quality", "draft"})).render.filter, FilterKind::mitchell)
      << "of which it says nothing";
}

TEST(SceneSettings, ThatApplyAreListedWithTheirSource) {
  const Scene scene = With({{"max_depth", "7", "a.scn:1:5"}, {"width", "40", "COMP30019"}});
  EXPECT_EQ(SettingsInForce(scene, Typed({"-width", "3"})), (std::vector<std::string>{"-max_depth 7 (a.scn:1:5)"}));
}

TEST(SceneSettings, TheLastOfAnOptionCounts) {
  const Scene scene = With({{"max_depth", "7", "a.scn:1:5"}, {"width", "40", "x"}, {"max_depth", "9", "a.scn:3:5"}});
  EXPECT_EQ(WithSettingsOf(scene, Typed({})).render.trace.max_depth, 9);
  EXPECT_EQ(SettingsInForce(scene, Typed({})), (std::vector<std::string>{"-width 40 (x)", "-max_depth 9 (a.scn:3:5)"}));
}

TEST(SceneSettings, OfAFlagTheLastCountsToo) {
  const Scene scene = With({{"fresnel", "on", "a.scn:1:5"}, {"fresnel", "off", "a.scn:2:5"}});
  EXPECT_FALSE(WithSettingsOf(scene, Typed({})).render.trace.fresnel);
}

}  // namespace
}  // namespace ray

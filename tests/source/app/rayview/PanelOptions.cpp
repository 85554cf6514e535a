#include "source/app/rayview/PanelOptions.h"

#include <gtest/gtest.h>

#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/RayproCommand.h"
#include "source/app/options/SceneSettings.h"

namespace ray {
namespace {

ViewerOptions Typed(const std::vector<std::string>& words) {
  return ReadCommandLine<ViewerOptions>(Program::rayview, words);
}

/// Returns the options with a change, for a scene without settings.
ViewerOptions Changed(const ViewerOptions& options, const std::string& name, const std::string& value) {
  return WithOption(Scene(), options, name, value);
}

std::string ValueOf(const ViewerOptions& options, const std::string& name) {
  for (const ShownOption& shown : OptionsOfPanels(options))
    if (shown.name == name) return shown.value;
  return "not there";
}

TEST(PanelOptions, AreThoseOfImagesWithTheirValues) {
  const ViewerOptions options = Typed({"a.scn", "-samples", "4", "-glossy", "-quiet", "-headless"});
  EXPECT_EQ(ValueOf(options, "samples"), "4");
  EXPECT_EQ(ValueOf(options, "glossy"), "on");
  EXPECT_EQ(ValueOf(options, "srgb"), "");
  EXPECT_EQ(ValueOf(options, "headless"), "not there");
  EXPECT_EQ(ValueOf(options, "quiet"), "not there");
}

TEST(PanelOptions, OneChangeLeavesTheOthersAsTheyAre) {
  const ViewerOptions options =
      Typed({"a b.scn", "-samples", "4", "-glossy", "-error", "2", "-image", "x y.png", "-accel", "bvh"});
  ViewerOptions changed = Changed(options, "mode", "path");
  EXPECT_EQ(changed.render.mode, RenderMode::path);
  for (const ShownOption& shown : OptionsOfPanels(options))
    if (shown.name != "mode") {
      EXPECT_EQ(ValueOf(changed, shown.name), shown.value) << shown.name;
    }
  EXPECT_EQ(changed.files.image, "x y.png");
  EXPECT_EQ(changed.files.scene, "a b.scn");
}

TEST(PanelOptions, AcceptTheirOwnValueAndDefault) {
  const ViewerOptions options = WithSettingsOf(Scene(), Typed({"a.scn"}));
  for (const ShownOption& shown : OptionsOfPanels(options)) {
    EXPECT_EQ(ValueOf(Changed(options, shown.name, shown.value), shown.name), shown.value) << shown.name;
    EXPECT_EQ(ValueOf(Changed(options, shown.name, ""), shown.name), shown.value) << shown.name;
    for (const std::string& choice : shown.choices) {
      if (shown.name == "simd" || shown.name == "sampler") continue;  // from the machine or a square
      EXPECT_EQ(ValueOf(Changed(options, shown.name, choice), shown.name), choice) << shown.name;
    }
  }
}

// A change of another option made them a choice of the user's, at which the image at rest then stopped.
TEST(PanelOptions, DefaultSamplesStayTheDefault) {
  const ViewerOptions options = WithSettingsOf(Scene(), Typed({"a.scn"}));
  EXPECT_EQ(ValueOf(options, "samples"), "16");
  const ViewerOptions glossy = Changed(options, "glossy", "on"), to_error = Changed(glossy, "error", "2");
  EXPECT_EQ(ValueOf(glossy, "samples"), "16");
  EXPECT_TRUE(glossy.default_image.has_its_samples);
  EXPECT_EQ(ValueOf(to_error, "samples"), "1") << "as many as the error needs";
  EXPECT_EQ(ValueOf(Changed(to_error, "error", ""), "samples"), "16");
  const ViewerOptions eight = Changed(glossy, "samples", "8");
  EXPECT_FALSE(eight.default_image.has_its_samples);
  EXPECT_TRUE(Changed(eight, "samples", "").default_image.has_its_samples);
  Scene scene;
  scene.settings = {{"samples", "16", "a.scn:1:1"}};
  EXPECT_FALSE(WithSettingsOf(scene, Typed({"a.scn"})).default_image.has_its_samples);
}

TEST(PanelOptions, AFlagCanBeCleared) {
  EXPECT_FALSE(Changed(Typed({"a.scn", "-glossy"}), "glossy", "").render.trace.glossy);
  EXPECT_TRUE(Changed(Typed({"a.scn"}), "glossy", "on").render.trace.glossy);
}

TEST(PanelOptions, ImpossibleValuesAreRefused) {
  const ViewerOptions options = Typed({"a.scn"});
  EXPECT_THROW(Changed(options, "samples", "none"), UsageError);
  EXPECT_THROW(Changed(options, "aperture", "0.1"), UsageError) << "without -focus";
  EXPECT_THROW(Changed(options, "motion", "1 2"), UsageError);
  EXPECT_EQ(ValueOf(Changed(options, "motion", "1 -2 3"), "motion"), "1 -2 3");
}

}  // namespace
}  // namespace ray

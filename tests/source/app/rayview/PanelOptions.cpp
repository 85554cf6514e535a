#include "source/app/rayview/PanelOptions.h"

#include <gtest/gtest.h>

#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/RayproCommand.h"

namespace ray {
namespace {

ViewerOptions Typed(const std::vector<std::string>& words) {
  return ReadCommandLine<ViewerOptions>(Program::rayview, words);
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
  ViewerOptions changed = WithOption(options, "mode", "path");
  EXPECT_EQ(changed.render.mode, RenderMode::path);
  for (const ShownOption& shown : OptionsOfPanels(options))
    if (shown.name != "mode") {
      EXPECT_EQ(ValueOf(changed, shown.name), shown.value) << shown.name;
    }
  EXPECT_EQ(changed.files.image, "x y.png");
  EXPECT_EQ(changed.files.scene, "a b.scn");
}

TEST(PanelOptions, AcceptTheirOwnValueAndDefault) {
  const ViewerOptions options = Typed({"a.scn"});
  for (const ShownOption& shown : OptionsOfPanels(options)) {
    EXPECT_EQ(ValueOf(WithOption(options, shown.name, shown.value), shown.name), shown.value) << shown.name;
    EXPECT_EQ(ValueOf(WithOption(options, shown.name, ""), shown.name), shown.value) << shown.name;
    for (const std::string& choice : shown.choices) {
      if (shown.name == "simd" || shown.name == "sampler") continue;  // from the machine or a square
      EXPECT_EQ(ValueOf(WithOption(options, shown.name, choice), shown.name), choice) << shown.name;
    }
  }
}

TEST(PanelOptions, AFlagCanBeCleared) {
  EXPECT_FALSE(WithOption(Typed({"a.scn", "-glossy"}), "glossy", "").render.trace.glossy);
  EXPECT_TRUE(WithOption(Typed({"a.scn"}), "glossy", "on").render.trace.glossy);
}

TEST(PanelOptions, ImpossibleValuesAreRefused) {
  const ViewerOptions options = Typed({"a.scn"});
  EXPECT_THROW(WithOption(options, "samples", "none"), UsageError);
  EXPECT_THROW(WithOption(options, "aperture", "0.1"), UsageError) << "without -focus";
  EXPECT_THROW(WithOption(options, "motion", "1 2"), UsageError);
  EXPECT_EQ(ValueOf(WithOption(options, "motion", "1 -2 3"), "motion"), "1 -2 3");
}

}  // namespace
}  // namespace ray

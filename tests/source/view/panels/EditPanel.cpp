// The panels that change a scene and open others, as a user clicks through them.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/source/view/panels/PanelTest.h"

namespace ray {
namespace {

class EditPanelTest : public UserOfPanels<900, 2400> {
 protected:
  void SetUp() override {
    Open(scenes_ / "hello.scn");
    Do("key Tab");
    Click("cone, line 18");
    for (const char* section : {"Material", "Lights", "Camera and lens", "Sky"}) Click(section);
  }
  static std::string At(double x, double y) { return std::to_string(x) + " " + std::to_string(y); }
  const Material& Red() const { return viewer_->scene().parsed.scene.materials[4]; }

  CopiedScenes scenes_;
};

TEST_F(EditPanelTest, ShowsTheMaterialOfTheChosenObjectByItsComment) {
  EXPECT_TRUE(Says("material, line 11: 3 red"));
  EXPECT_TRUE(Says("diffuse (kd)"));
  EXPECT_TRUE(Says("0.8 0.22 0.12"));
}

TEST_F(EditPanelTest, TakesAColorThatIsTyped) {
  Click("diffuse (kd)");
  Do("type 0.1 0.6 0.15\nkey Enter");
  EXPECT_EQ(Red().kd, (R2::Color{0.1, 0.6, 0.15})) << viewer_->Message();
  Click("undo");
  EXPECT_EQ(Red().kd, (R2::Color{0.8, 0.22, 0.12}));
  Click("diffuse (kd)");
  Do("type green\nkey Enter");
  EXPECT_EQ(Red().kd, (R2::Color{0.8, 0.22, 0.12}));
  EXPECT_EQ(viewer_->Message(), "diffuse (kd) must be three numbers with blanks between");
}

TEST_F(EditPanelTest, ThreeClicksChangeAColorAndSaveIt) {
  Click("pick diffuse (kd)");
  Click("picker of diffuse (kd)");
  EXPECT_NE(Red().kd, (R2::Color{0.8, 0.22, 0.12}));
  EXPECT_TRUE(viewer_->state().editor.HasUnsaved());
  Click("save");
  EXPECT_FALSE(viewer_->state().editor.HasUnsaved()) << viewer_->Message();
}

TEST_F(EditPanelTest, GivesAMaterialAMirrorAndGloss) {
  Click("add mirror");
  EXPECT_EQ(viewer_->state().editor.History().Done(), 1u) << viewer_->Message();
  Click("mirror (kr)");
  Do("type 0.3 0.2 0.1\nkey Enter");
  EXPECT_EQ(Red().kr, (R2::Color{0.3, 0.2, 0.1})) << viewer_->Message();
  Click("add gloss");
  EXPECT_EQ(Red().gloss, 1000);
  Click("gloss exponent");
  Do("type 50\nkey Enter");
  EXPECT_EQ(Red().gloss, 50) << viewer_->Message();
  EXPECT_FALSE(Find("add gloss"));
  Click("gloss exponent");
  Do("type -1\nkey Enter");
  EXPECT_EQ(Red().gloss, 50);
  EXPECT_NE(viewer_->Message().find("exponent must be positive"), std::string::npos) << viewer_->Message();
  Do("key Control+Z\nkey Control+Z\nkey Control+Z\nkey Control+Z");
  EXPECT_EQ(Red().gloss, 0);
  EXPECT_TRUE(Find("add mirror"));
  EXPECT_FALSE(viewer_->state().editor.HasUnsaved()) << "the text is as it was, to the byte";
}

TEST_F(EditPanelTest, GivesAMaterialATextureAndTakesItAway) {
  Click("texture");
  Do("type textures/checker.png\nkey Enter");
  ASSERT_TRUE(Red().texture) << viewer_->Message();
  Click("texture");
  Do("type no-such.png\nkey Enter");
  EXPECT_TRUE(Red().texture);
  EXPECT_NE(viewer_->Message().find("no such file"), std::string::npos) << viewer_->Message();
  Click("texture");
  Do("type 0\nkey Enter");
  EXPECT_FALSE(Red().texture) << viewer_->Message();
}

TEST_F(EditPanelTest, ADragOfASliderIsOneStep) {
  const auto slider = Find("slide shininess (n)");
  ASSERT_TRUE(slider);
  Do("drag left " + At(slider->x, slider->y) + " " + At(slider->x + 60, slider->y));
  EXPECT_NE(Red().n, 40);
  EXPECT_EQ(viewer_->state().editor.History().Done(), 1u);
  Do("key Control+Z");
  EXPECT_EQ(Red().n, 40);
}

TEST_F(EditPanelTest, ListsLightsAndChangesTheChosenOne) {
  Click("point_light, line 6");
  Click("color");
  Do("type 2 2 2\nkey Enter");
  EXPECT_EQ(viewer_->scene().parsed.scene.lights[1]->MadeFrom().arguments[0], 2) << viewer_->Message();
}

TEST_F(EditPanelTest, ExplainsWhatCannotBeEdited) {
  std::ofstream(scenes_ / "hello.scn") << "define r 1\nsphere -1 0 0 0 $r\n";
  Do("tick 1");
  Click("sphere, line 2");
  EXPECT_TRUE(Says("$r is a variable"));
  std::ofstream(scenes_ / "hello.scn") << "define r 1\nsphere -1 0 0 0 ( $r / 2 )\n";
  Do("tick 1");
  Click("sphere, line 2");
  EXPECT_TRUE(Says("( $r / 2 ) is a formula"));
}

TEST_F(EditPanelTest, AListOfTheFolderOpensScenes) {
  EXPECT_FALSE(Find("glass.scn"));
  Do("key Control+O");
  Click("glass.scn");
  EXPECT_EQ(viewer_->state().settings.scene, scenes_ / "glass.scn");
  Do("key Control+O");
  EXPECT_FALSE(Find("hello.scn"));
}

}  // namespace
}  // namespace ray

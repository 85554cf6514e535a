#include "tests/source/view/panels/PanelTest.h"

namespace ray {
namespace {

TEST_F(PanelTest, TheStatusBarShowsSceneProgressAndPixel) {
  RenderSettings two;
  two.samples = 2;
  Open(project::Root() / "scenes/hello.scn", two);
  Do("resize 1000 400\nkey Tab");
  EXPECT_TRUE(Says("hello.scn 1000x400")) << viewer_->TextOfPanels();
  Do("key S\nwait trace\nmove 100 100");
  EXPECT_TRUE(Says(viewer_->state().status.Text())) << viewer_->TextOfPanels();
  EXPECT_NE(viewer_->state().status.Text().find("2 samples"), std::string::npos) << viewer_->state().status.Text();
  const R2::Point at = viewer_->state().PointerInShownImage();
  const std::string pixel = std::to_string(static_cast<int>(at.x)) + " " + std::to_string(static_cast<int>(at.y));
  EXPECT_TRUE(Says(pixel + "  ")) << viewer_->TextOfPanels();
}

TEST_F(PanelTest, TheStatusBarStaysWithoutPanelsAndLetsClicksThrough) {
  EXPECT_FALSE(viewer_->Show().panels) << "a script draws the image alone";
  shows_bar_ = true;
  Open(project::Root() / "scenes/hello.scn");
  EXPECT_TRUE(Says("hello.scn 512x512")) << viewer_->TextOfPanels();
  EXPECT_TRUE(Says("H help  Tab panels"));
  const double bar = viewer_->state().panels->HeightOfBar();
  const FrameState shown = viewer_->Show();
  EXPECT_EQ(shown.view.height, 512) << "the bar lies over the image";
  ASSERT_TRUE(shown.panels);
  EXPECT_TRUE(std::ranges::any_of(shown.panels->parts, [&](const auto& part) { return part.top >= 512 - bar; }));
  Do("click left 256 4");
  EXPECT_TRUE(viewer_->Picked());
  Do("tick 9\nkey Tab");
  EXPECT_EQ(viewer_->Show().view.height, 512 - bar);
}

}  // namespace
}  // namespace ray

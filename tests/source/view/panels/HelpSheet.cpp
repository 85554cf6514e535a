#include "source/view/panels/HelpSheet.h"

#include "tests/source/view/panels/PanelTest.h"

namespace ray {
namespace {

TEST_F(PanelTest, TheHelpIsSearchedByTyping) {
  for (const char* panels : {"tick 0.1", "key Tab"}) {
    Do(std::string("resize 800 800\n") + panels);
    Do("key H");
    const std::string all = viewer_->TextOfPanels();
    for (const HelpRow& row : RowsOfHelp()) EXPECT_NE(all.find(row.text.substr(0, 20)), std::string::npos) << row.text;
    Do("type EXPOS");
    EXPECT_TRUE(Says("reset the exposure")) << viewer_->TextOfPanels();
    EXPECT_FALSE(Says("bookmark")) << viewer_->TextOfPanels();
    Do("key Escape");
    EXPECT_FALSE(Says("reset the exposure")) << viewer_->TextOfPanels();
    Do("key H");
    EXPECT_TRUE(Says("bookmark")) << "it opens whole again";
    Do("key Escape");
  }
}

// A window tells of the letter after the key, and that would be searched for.
TEST_F(PanelTest, TheLetterThatOpensTheHelpIsNotSearchedFor) {
  Do("press H\ntype h\nrelease H");
  EXPECT_TRUE(Says("toggle faces")) << viewer_->TextOfPanels();
  Do("type hh");
  EXPECT_FALSE(Says("toggle faces")) << viewer_->TextOfPanels();
}

// A window tells of a key that is held as of one that is pressed again.
TEST_F(PanelTest, AHeldKeyCountsAgainEachTimeItComes) {
  Do("resize 800 800\nkey H");
  Do("type exposqq\npress Backspace\npress Backspace");
  EXPECT_TRUE(Says("reset the exposure")) << viewer_->TextOfPanels();
  Do("tick 5");
  EXPECT_TRUE(Says("reset the exposure")) << "time alone takes nothing away";
  EXPECT_FALSE(Says("bookmark")) << viewer_->TextOfPanels();
  Do("press Backspace\npress Backspace\npress Backspace\npress Backspace\npress Backspace\nrelease Backspace");
  EXPECT_TRUE(Says("bookmark")) << viewer_->TextOfPanels();
}

// Keys that a sheet of help lies over still do what they say, but for those that are typed into it.
TEST_F(PanelTest, TheHelpKeepsClicksFromTheImageBelow) {
  Do("key H\nclick left 256 256");
  EXPECT_FALSE(viewer_->Picked());
  Do("key Escape\nclick left 256 256");
  EXPECT_TRUE(viewer_->Picked());
}

TEST_F(PanelTest, TheHelpIsAboveTheStatusBar) {
  Do("key Tab\nkey H");
  const double bar = viewer_->state().panels->HeightOfBar();
  const FrameState shown = viewer_->Show();
  int above = 0;
  for (const PanelDrawing::Part& part : shown.panels->parts) {
    if (part.left <= 0 || part.right >= shown.view.width || part.top >= shown.size.height - bar) continue;
    ++above;
    EXPECT_LE(part.bottom, shown.size.height - bar);
  }
  EXPECT_GT(above, 0);
}

}  // namespace
}  // namespace ray

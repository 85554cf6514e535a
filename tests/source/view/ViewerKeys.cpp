// What keys do, and that they say so.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "source/view/KeyBindings.h"
#include "tests/source/view/ScriptedViewer.h"

namespace ray {
namespace {

TEST_F(ViewerTest, EveryKeyIsInTheHelpAndDoesSomething) {
  const auto help = LinesOfHelp();
  std::set<std::string> names;
  for (const KeyBinding& binding : KeyBindings()) {
    const std::string name = NameOf(binding.key, binding.modifiers);
    EXPECT_TRUE(names.insert(name).second) << name << " is bound twice";
    const bool is_bookmark = name.back() >= '1' && name.back() <= '9' && name[0] != 'F' && name[0] != 'P';
    const std::string as_told = is_bookmark ? name.substr(0, name.size() - 1) + "1-9" : name;
    const bool is_told = std::any_of(help.begin(), help.end(), [&](const std::string& line) {
      return (" " + line).find(" " + as_told + " ") != std::string::npos;
    });
    EXPECT_TRUE(is_told) << name;
  }
  // What each needs before it can do anything, and then something that can be told from outside must have changed.
  const std::map<std::string, std::string> before{
      {"I", "key S\nwait trace"},
      {"V", "key S\nwait trace"},
      {"Shift+X", "key X"},
      {"Shift+F", "click left 32 24\ntick 1"},
      {"Z", "key ["},
      {"Shift+Z", "key [\nkey Z"},
      {"Pad1", "key Pad3"},
      {"Pad0", "key Pad3"},
      {"N", "click right 32 24"},
      {"Shift+N", "click right 32 24"},
      {"O", "click right 32 24"},
      {"Backspace", "click right 32 24"},
      {"Left", "click right 32 24"},
      {"Right", "click right 32 24"},
      {"Up", "click right 32 24"},
      {"Down", "click right 32 24"},
      {"Control+0", "key Control+Up"},
      {"R", "key P\nwait trace"},
      {"Shift+R", "key P\nwait trace\nkey R"},
      {"D", "key P\nwait trace\nkey R"},
      {"Shift+D", "key P\nwait trace\nkey R"},
  };
  const CopiedScenes folder;
  for (const KeyBinding& binding : KeyBindings()) {
    const std::string name = NameOf(binding.key, binding.modifiers);
    host_ = {};
    Open(folder / "hello.scn");
    if (const auto found = before.find(name); found != before.end()) Do(found->second);
    const auto seen = [&] {
      const FrameState shown = viewer_->Show();
      return viewer_->Describe() + std::to_string(host_.drawings) + host_.printed + host_.rays + host_.clipboard +
             std::to_string(shown.lines->size()) + std::to_string(viewer_->IsClosed());
    };
    const std::string without = seen();
    Do("press " + name);
    EXPECT_NE(seen(), without) << name << " does nothing";
    Do("release " + name);
  }
}

TEST_F(ViewerTest, EscapeClosesThingsOneByOneAndNeverQuits) {
  RenderSettings slow;
  slow.samples = 100'000;
  Open(project::Root() / "scenes/hello.scn", slow);
  Do("key S\nkey X\nclick left 10 24\nkey H");
  EXPECT_EQ(StateLine("help"), "yes");
  Do("key Escape");
  EXPECT_EQ(StateLine("help"), "no");
  EXPECT_TRUE(viewer_->Picked());
  Do("key Escape");
  EXPECT_FALSE(viewer_->Picked());
  EXPECT_NE(StateLine("cut"), "no");
  Do("key Escape");
  EXPECT_EQ(StateLine("cut"), "no");
  EXPECT_EQ(StateLine("trace"), "running");
  Do("key Escape\nwait trace");
  EXPECT_EQ(StateLine("trace"), "stopped");
  EXPECT_TRUE(host_.traced.empty());
  Do("key Escape\nkey Escape");
  EXPECT_FALSE(viewer_->IsClosed());
}

// An hour of rendering is not thrown away by one slip.
TEST_F(ViewerTest, QAndTheWindowsEndAskOnceWhileATraceRuns) {
  for (const std::string quit : {"key Q", "close"}) {
    Open(project::Root() / "scenes/hello.scn");
    Do(quit);
    EXPECT_TRUE(viewer_->IsClosed()) << quit;
    RenderSettings slow;
    slow.samples = 100'000;
    Open(project::Root() / "scenes/hello.scn", slow);
    Do("key S\n" + quit);
    EXPECT_FALSE(viewer_->IsClosed()) << quit;
    EXPECT_NE(viewer_->Message().find("once more quits"), std::string::npos) << viewer_->Message();
    Do("key E\n" + quit);
    EXPECT_FALSE(viewer_->IsClosed()) << "another key is an answer too";
    Do(quit);
    EXPECT_TRUE(viewer_->IsClosed()) << quit;
  }
}

TEST_F(ViewerTest, EscapeWithNothingRunningSaysThatThereIsNothing) {
  Do("key Escape");
  EXPECT_EQ(viewer_->Message(), "nothing to close; Q quits");
}

// Some keys said again what the help says of them.
TEST_F(ViewerTest, KeysReportTheirEffectNotTheirPurpose) {
  for (const bool has_something : {false, true}) {
    std::string help;
    const CopiedScenes folder;
    for (const KeyBinding& binding : KeyBindings()) {
      Open(folder / "hello.scn");
      if (has_something) Do("key [\nkey Control+1\nclick left 32 24\nclick right 32 24\nkey X");
      if (*binding.help) help = binding.help;
      const std::string name = NameOf(binding.key, binding.modifiers);
      Do("tick 60");
      const std::string before = viewer_->Message();
      Do("press " + name);
      if (viewer_->IsClosed()) continue;
      // Once the file has its name, the program tells it.
      if (name == "F1") continue;
      EXPECT_NE(viewer_->Message(), before) << name;
      EXPECT_NE(viewer_->Message(), help) << name;
    }
  }
}

TEST_F(ViewerTest, ToggleKeysSayOnOrOff) {
  for (const char* key : {"E", "W", "L", "Shift+L", "Shift+C", "P", "F7", "F2", "F6", "G", "T", "X"}) {
    Do(std::string("key ") + key);
    const std::string first = viewer_->Message();
    Do(std::string("key ") + key);
    EXPECT_NE(viewer_->Message(), first) << key;
  }
}

TEST_F(ViewerTest, MessagesFadeAndTheFirstOneNamesTheHelp) {
  Do("resize 128 96");  // with room for a message in one line
  EXPECT_TRUE(viewer_->Show().labels.empty()) << "a script that only draws gets the scene alone";
  Do("tick 0.1");
  ASSERT_EQ(viewer_->Show().labels.size(), 1u);
  EXPECT_EQ(viewer_->Show().labels[0].text, "H: help");
  EXPECT_EQ(viewer_->Show().labels[0].color[3], 255);
  Do("tick 4.4");
  const int fading = viewer_->Show().labels.at(0).color[3];
  EXPECT_GT(fading, 0);
  EXPECT_LT(fading, 255);
  viewer_->Handle(TickEvent{2});
  EXPECT_TRUE(viewer_->Update()) << "it is to be drawn without the message";
  EXPECT_TRUE(viewer_->Show().labels.empty());
  Do("key E");
  EXPECT_EQ(viewer_->Show().labels.at(0).text, "edges on");
}

}  // namespace
}  // namespace ray

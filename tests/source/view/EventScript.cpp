#include "source/view/EventScript.h"
#include "tests/Folder.h"

#include <gtest/gtest.h>

namespace ray {
namespace {

std::vector<ScriptStep> Read(const std::string& text) { return ReadEventScript({"test.events", text}); }

std::string Written(const std::vector<ScriptStep>& steps) {
  std::string text;
  for (const ScriptStep& step : steps)
    if (const auto* event = std::get_if<Event>(&step.what)) text += ScriptLine(*event);
  return text;
}

std::string Complaint(const std::string& text) {
  return project::MessageOf<SceneErrors>([&] { Read(text); });
}

TEST(EventScript, WhatIsWrittenReadsBackAsTheSame) {
  const std::string script =
      "press Control+Shift+S\nrelease F11\ndown left 1.5 2 Control Shift\nup middle -3 4\nmove 0.1 0.2\n"
      "scroll -2 5 6\nresize 640 480\ndrop a file.scn\ntick 0.016\nclose\npress [\npress ,\npress Pad7\n";
  EXPECT_EQ(Written(Read(script)), script);
}

// Whatever a user did is to be done again: letters that mean something to scripts, a window put away, a long pause.
TEST(EventScript, WhatIsRecordedCanBeRead) {
  for (const char* script : {"type #\n", "type #1\n", "type a#\n", "drop #1 of 2.scn\n", "type tick\n"})
    EXPECT_EQ(Written(Read(script)), script);
  EXPECT_EQ(ScriptLine(ResizeEvent{0, 0, 1}), "");
  EXPECT_EQ(ScriptLine(ResizeEvent{640, 0, 1}), "");
  EXPECT_EQ(ScriptLine(TickEvent{3600}), "tick 3600\n");
  const std::string pause = ScriptLine(TickEvent{7500.5});
  EXPECT_EQ(pause, "tick 3600\ntick 3600\ntick 300.5\n");
  EXPECT_EQ(Written(Read(pause)), pause);
}

TEST(EventScript, EveryKeyHasANameOfItsOwn) {
  int keys = 0;
  for (int k = 1; k < 500; ++k) {
    const std::string name = NameOf(static_cast<Key>(k));
    if (name == "unknown") continue;
    ++keys;
    ASSERT_EQ(KeyNamed(name), static_cast<Key>(k)) << name;
  }
  EXPECT_EQ(keys, 26 + 10 + 12 + 10 + 21);
  EXPECT_EQ(KeyNamed("s"), KeyNamed("S"));
  EXPECT_FALSE(KeyNamed("F13"));
}

TEST(EventScript, ShortStepsStandForSeveralEvents) {
  EXPECT_EQ(Written(Read("key S")), "press S\nrelease S\n");
  EXPECT_EQ(Written(Read("click right 7 8 Shift")), "down right 7 8 Shift\nup right 7 8 Shift\n");
  const auto drag = Read("drag left 0 0 80 40");
  ASSERT_EQ(drag.size(), 10u);
  EXPECT_EQ(Written({drag[1]}), "move 10 5\n");
}

TEST(EventScript, WaitsAndImagesAreSteps) {
  const auto steps = Read("wait trace  # until it is there\nwait 0.5\nscreenshot my picture.png\nprint\nwait rows 7");
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_EQ(std::get<WaitForRows>(steps[4].what).rows, 7);
  EXPECT_TRUE(std::holds_alternative<WaitForTrace>(steps[0].what));
  EXPECT_EQ(std::get<WaitSeconds>(steps[1].what).seconds, 0.5);
  EXPECT_EQ(std::get<Screenshot>(steps[2].what).file, "my picture.png");
  EXPECT_TRUE(std::holds_alternative<PrintState>(steps[3].what));
}

TEST(EventScript, MistakesAreShownInTheirPlace) {
  EXPECT_NE(Complaint("key S\nkye Q\n").find("test.events:2:1: error: unknown step 'kye'"), std::string::npos);
  EXPECT_NE(Complaint("kye Q\n").find("did you mean 'key'?"), std::string::npos);
  EXPECT_NE(Complaint("key Nonsense").find("test.events:1:5: error: unknown key 'Nonsense'"), std::string::npos);
  EXPECT_NE(Complaint("move 1").find("y is missing"), std::string::npos);
  EXPECT_NE(Complaint("down left 1 2 Alt").find("a modifier must be Shift or Control"), std::string::npos);
  EXPECT_NE(Complaint("move 1 2 3").find("unexpected extra word after 'move'"), std::string::npos);
  EXPECT_NE(Complaint("resize 0 5").find("width must be 1 to"), std::string::npos);
  EXPECT_NE(Complaint("tick -1").find("seconds must be"), std::string::npos);
  EXPECT_NE(Complaint("click top 1 2\nmove x 2").find("test.events:2:6"), std::string::npos) << "both are told";
}

}  // namespace
}  // namespace ray

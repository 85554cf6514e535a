#include "source/parse/SceneError.h"

#include <gtest/gtest.h>

#include "source/parse/Text.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

SceneError Example() {
  SceneError error;
  error.file = "scenes/room.scn";
  error.line = 14;
  error.column = 3;
  error.message = "unknown command 'spere'";
  error.source_line = "  spere 0  0 1 0  0.5";
  error.length = 5;
  error.hint = "did you mean 'sphere'?";
  error.included_from = {"scenes/main.scn:3"};
  return error;
}

TEST(SceneError, HasTheShapeTheManualShows) {
  EXPECT_EQ(Example().Format(),
            "scenes/room.scn:14:3: error: unknown command 'spere'\n"
            "   14 |   spere 0  0 1 0  0.5\n"
            "      |   ^~~~~ did you mean 'sphere'?\n"
            "included from scenes/main.scn:3");
}

TEST(SceneError, TheCaretStaysUnderItsWordBehindTabsAndUmlauts) {
  SceneError error = Example();
  error.source_line = "\t\xC3\xA4\tspere";
  error.column = 4;
  error.hint.clear();
  error.included_from.clear();
  EXPECT_EQ(error.Format(),
            "scenes/room.scn:14:4: error: unknown command 'spere'\n"
            "   14 | \t\xC3\xA4\tspere\n"
            "      | \t \t^~~~~");
}

TEST(SceneError, AMistakeOfTheWholeFileHasNoLine) {
  EXPECT_EQ(ErrorIn("a.scn", "no such file", "look elsewhere").Format(), "a.scn: error: no such file; look elsewhere");
}

TEST(SceneError, TwentyAreShownAndTheRestIsCounted) {
  const SceneErrors twenty(std::vector<SceneError>(20, ErrorIn("a", "b")));
  EXPECT_EQ(std::string(twenty.what()).find("more"), std::string::npos);
  EXPECT_TRUE(
      std::string(SceneErrors(std::vector<SceneError>(21, ErrorIn("a", "b"))).what()).ends_with("\nand 1 more error"));
  EXPECT_TRUE(std::string(SceneErrors(std::vector<SceneError>(45, ErrorIn("a", "b"))).what())
                  .ends_with("\nand 25 more errors"));
}

TEST(Extremes, K8_OnlyTextOfAFileReachesTheTerminal) {
  SceneError error = ErrorIn("bell\a.scn", "x");
  EXPECT_EQ(error.Format(), "bell\\x07.scn: error: x");
  EXPECT_EQ(Quoted("\x1b[2J"), "'\\x1b[2J'");
  EXPECT_EQ(Quoted("\xC2\x9B"
                   "31m"),
            "'\\xc2\\x9b31m'");  // a control character in one
  EXPECT_EQ(Quoted("\xE2\x80\xAE"
                   "txt"),
            "'\\xe2\\x80\\xaetxt'");                       // changes the direction of writing
  EXPECT_EQ(Quoted("\xFF\xC3"), "'\\xff\\xc3'");           // not UTF-8
  EXPECT_EQ(Quoted("\xC0\xAF"), "'\\xc0\\xaf'");           // not the shortest form
  EXPECT_EQ(Quoted("\xED\xA0\x80"), "'\\xed\\xa0\\x80'");  // half of a pair
  EXPECT_EQ(Quoted("\xF0\x9F\x94\xA6"), "'\xF0\x9F\x94\xA6'");
  EXPECT_EQ(ShownLine("a\x1b\tb\xC2\x9B"), "a?\tb?");
}

TEST(Extremes, K8_LongWordsAreShortened) {
  EXPECT_EQ(Quoted(std::string(10000, 'x')), "'" + std::string(60, 'x') + "...' (10000 bytes)");
}

TEST(Suggestion, OneSlipOfTheKeyboardIsUnderstood) {
  constexpr std::string_view choices[] = {"box", "point_light", "sphere"};
  EXPECT_EQ(Suggestion("spere", choices, "commands"), "did you mean 'sphere'?");
  EXPECT_EQ(Suggestion("shpere", choices, "commands"), "did you mean 'sphere'?");
  EXPECT_EQ(Suggestion("SPHERE", choices, "commands"), "did you mean 'sphere'?");
  EXPECT_EQ(Suggestion("pointlight", choices, "commands"), "did you mean 'point_light'?");
  EXPECT_EQ(Suggestion("boxx", choices, "commands"), "did you mean 'box'?");
}

TEST(Suggestion, AWordLikeNoChoiceListsThemAll) {
  constexpr std::string_view choices[] = {"box", "sphere"};
  EXPECT_EQ(Suggestion("cat", choices, "commands"), "commands are box, sphere");
  EXPECT_EQ(Suggestion(std::string(1000, 'x'), choices, "commands"), "commands are box, sphere");
}

}  // namespace
}  // namespace ray

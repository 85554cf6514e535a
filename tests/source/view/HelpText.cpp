#include "source/view/HelpText.h"

#include <gtest/gtest.h>

#include "source/view/KeyBindings.h"
#include "source/view/Viewer.h"

namespace {

TEST(HelpText, MessageLinesFitAndBreakOnlyWordsThatDoNot) {
  EXPECT_EQ(ray::InLines("as it is,  with blanks", 40), std::vector<std::string>{"as it is,  with blanks"});
  EXPECT_EQ(ray::InLines("saved to a/long/name", 9), (std::vector<std::string>{"saved to", "a/long/na", "me"}));
  EXPECT_EQ(ray::InLines("ab", 0), (std::vector<std::string>{"a", "b"}));
}

// Names of files are UTF-8: a line is as wide as its letters, and is not cut within one.
TEST(HelpText, LinesCountLettersAndNotBytes) {
  EXPECT_EQ(ray::CountLetters("\u00fc\u5149x"), 3u);
  EXPECT_EQ(ray::InLines("\u00fc\u00fc\u00fc \u00fc\u00fc", 6),
            std::vector<std::string>{"\u00fc\u00fc\u00fc \u00fc\u00fc"});
  EXPECT_EQ(ray::InLines("\u00fc\u00fc\u00fc", 2), (std::vector<std::string>{"\u00fc\u00fc", "\u00fc"}));
}

TEST(HelpText, TextsStandBelowOneAnother) {
  const auto lines = ray::HelpLines({{"", "Keys"}, {"A", "first"}, {"Control+B", "second"}});
  EXPECT_EQ(lines.at(0), "Keys");
  EXPECT_EQ(lines.at(1).find("first"), lines.at(2).find("second"));
}

TEST(HelpText, BeginsWithTheMouse) {
  const auto rows = ray::RowsOfHelp();
  EXPECT_TRUE(rows.at(0).keys.empty());
  EXPECT_EQ(rows.at(0).text, "Mouse");
  EXPECT_EQ(rows.at(1).keys, "left drag");
}

}  // namespace

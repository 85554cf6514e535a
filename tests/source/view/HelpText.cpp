#include "source/view/HelpText.h"

#include <gtest/gtest.h>

#include "source/view/Viewer.h"

namespace {

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(HelpText, KeepsToItsColumnsAndLosesNoWord) {
  const auto rows = ray::Viewer::HelpRows();
  const auto words = [](std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    return text;
  };
  const std::string all = words(Joined(ray::HelpLines(rows, 0)));
  for (const int columns : {40, 62, 100}) {
    const auto lines = ray::HelpLines(rows, columns);
    for (const std::string& line : lines) EXPECT_LE(line.size(), static_cast<std::size_t>(columns)) << line;
    EXPECT_EQ(words(Joined(lines)), all) << columns;
  }
}

TEST(HelpText, LinesOfAMessageHaveRoomAndBreakOnlyWordsThatHaveNone) {
  EXPECT_EQ(ray::InLines("as it is,  with blanks", 40), std::vector<std::string>{"as it is,  with blanks"});
  EXPECT_EQ(ray::InLines("saved to a/long/name", 9), (std::vector<std::string>{"saved to", "a/long/na", "me"}));
  EXPECT_EQ(ray::InLines("ab", 0), (std::vector<std::string>{"a", "b"}));
}

TEST(HelpText, PagesHaveNoMoreLinesThanThereIsRoomAndAllRows) {
  const auto rows = ray::Viewer::HelpRows();
  for (const int lines : {2, 7, 28, 1000}) {
    std::size_t count = 0;
    for (const auto& page : ray::HelpPages(rows, 62, lines)) {
      EXPECT_LE(page.size(), static_cast<std::size_t>(lines));
      count += page.size() - 1;  // the last says which page it is
    }
    EXPECT_EQ(count, ray::HelpLines(rows, 62).size()) << lines;
  }
  EXPECT_EQ(ray::HelpPages(rows, 62, 1000).size(), 1u);
}

TEST(HelpText, BeginsWithTheMouse) {
  const auto rows = ray::Viewer::HelpRows();
  EXPECT_TRUE(rows.at(0).keys.empty());
  EXPECT_EQ(rows.at(0).text, "Mouse");
  EXPECT_EQ(rows.at(1).keys, "left drag");
}

}  // namespace

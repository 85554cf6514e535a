#include "source/parse/Tokenizer.h"

#include <gtest/gtest.h>

#include <vector>

namespace ray {
namespace {

std::string Words(const std::string& bytes, Tokenizer::Comments comments = Tokenizer::Comments::hash) {
  const Text text{"t", bytes};
  Tokenizer tokens(text, comments);
  std::string all;
  while (const auto t = tokens.Next())
    all += std::string(t->text) + "@" + std::to_string(t->line) + ":" + std::to_string(t->column) +
           (t->starts_line ? "! " : " ");
  return all;
}

TEST(Tokenizer, ErrorsPointAtTheRightLineAndColumn) { EXPECT_EQ(Words("a bc\n  d"), "a@1:1! bc@1:3 d@2:3! "); }

TEST(Tokenizer, LineEndsOfEverySystemCountOnce) {
  EXPECT_EQ(Words("a\nb"), "a@1:1! b@2:1! ");
  EXPECT_EQ(Words("a\r\nb"), "a@1:1! b@2:1! ");
  EXPECT_EQ(Words("a\rb"), "a@1:1! b@2:1! ");
  EXPECT_EQ(Words("a\r\rb"), "a@1:1! b@3:1! ");
  EXPECT_EQ(Words("a\n\rb"), "a@1:1! b@3:1! ");
}

TEST(Tokenizer, AllWhiteSpaceSeparatesAndATabIsOneColumn) {
  EXPECT_EQ(Words("a\tb\vc\fd"), "a@1:1! b@1:3 c@1:5 d@1:7 ");
}

TEST(Tokenizer, ColumnsCountCharactersNotBytes) { EXPECT_EQ(Words("\xC3\xA4 b"), "\xC3\xA4@1:1! b@1:3 "); }

TEST(Tokenizer, AByteOrderMarkIsSkipped) {
  EXPECT_EQ(Words("\xEF\xBB\xBF"
                  "a"),
            "a@1:1! ");
}

TEST(Tokenizer, ACommentBeginsOnlyAtTheStartOfAWord) {
  EXPECT_EQ(Words("a # b c\nd"), "a@1:1! d@2:1! ");
  EXPECT_EQ(Words("a#b #c"), "a#b@1:1! ");
  EXPECT_EQ(Words("1.9#object x\n-2#\n3 a#1"), "1.9@1:1! -2@2:1! 3@3:1! a#1@3:3 ");
  EXPECT_EQ(Words("1#object", Tokenizer::Comments::none), "1#object@1:1! ");
  EXPECT_EQ(Words("#\r#\r\n# x"), "");
  EXPECT_EQ(Words("#vertex 1", Tokenizer::Comments::none), "#vertex@1:1! 1@1:9 ");
}

// Otherwise the number before the # would be read, and the words after it would be skipped.
TEST(Tokenizer, TheHashInOldWindowsNansStartsNoComment) {
  EXPECT_EQ(Words("2 1.#QNAN 3"), "2@1:1! 1.#QNAN@1:3 3@1:11 ");
  EXPECT_EQ(Words("-1.#IND00 1.#INF"), "-1.#IND00@1:1! 1.#INF@1:11 ");
  EXPECT_EQ(Words("1#comment 1.#comment\n1.#information"), "1@1:1! 1.@2:1! ");
}

TEST(Tokenizer, QuotedNamesEndAtTheirQuoteOrLine) {
  const auto words = [](const std::string& bytes) {
    const Text text{"t", bytes};
    Tokenizer tokens(text, Tokenizer::Comments::hash, Tokenizer::Joints::none, Tokenizer::Quotes::names);
    std::vector<std::string> all;
    while (const auto t = tokens.Next()) all.emplace_back(t->text);
    return all;
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(words("a \"b c\" d"), (Words{"a", "\"b c\"", "d"}));
  EXPECT_EQ(words("\"1 # 2\" # 3"), (Words{"\"1 # 2\""}));
  EXPECT_EQ(words(R"("a \" b \\" c)"), (Words{R"("a \" b \\")", "c"}));
  EXPECT_EQ(words("\"a b\nc\""), (Words{"\"a b", "c\""}));
  EXPECT_EQ(words("\"a\"b"), (Words{"\"a\"", "b"}));
  EXPECT_EQ(words("\"a\\"), (Words{"\"a\\"}));
  EXPECT_EQ(words("a\"b c\""), (Words{"a\"b", "c\""}));
}

TEST(Tokenizer, ABackslashJoinsLinesIfEnabled) {
  const auto words = [](const std::string& bytes) {
    const Text text{"t", bytes};
    Tokenizer tokens(text, Tokenizer::Comments::hash, Tokenizer::Joints::backslash);
    std::string all;
    while (const auto t = tokens.Next())
      all += std::string(t->text) + "@" + std::to_string(t->line) + (t->starts_line ? "! " : " ");
    return all;
  };
  EXPECT_EQ(words("a b\\\nc\nd"), "a@1! b@1 c@2 d@3! ");
  EXPECT_EQ(words("a b \\\r\n c\\\r\n\r\nd"), "a@1! b@1 c@2 d@4! ");
  EXPECT_EQ(words("a\\ \t\n b"), "a@1! b@2 ") << "blanks are easily left behind it";
  EXPECT_EQ(words("a\\b c\\"), "a\\b@1! c@1 ");
  EXPECT_EQ(words("a\\\n\\\n\\\nb"), "a@1! b@4 ");
  EXPECT_EQ(words("a # b\\\nc"), "a@1! c@2! ") << "a comment ends with its line";
  EXPECT_EQ(Words("a\\\nb"), "a\\@1:1! b@2:1! ");
}

TEST(Tokenizer, AnEmptyTextHasNoWords) {
  EXPECT_EQ(Words(""), "");
  EXPECT_EQ(Words(" \n\t"), "");
}

TEST(Tokenizer, PeekingTakesNothing) {
  const Text text{"t", "a b"};
  Tokenizer tokens(text, Tokenizer::Comments::hash);
  EXPECT_EQ(tokens.Peek()->text, "a");
  EXPECT_EQ(tokens.Peek()->text, "a");
  EXPECT_EQ(tokens.Next()->text, "a");
  EXPECT_EQ(tokens.Next()->text, "b");
  EXPECT_FALSE(tokens.Peek());
  EXPECT_FALSE(tokens.Next());
}

TEST(Tokenizer, SkippingALineStopsAtTheNext) {
  const Text text{"t", "a b c\nd"};
  Tokenizer tokens(text, Tokenizer::Comments::hash);
  tokens.Next();
  EXPECT_EQ(tokens.SkipLine(1), 2u);
  EXPECT_EQ(tokens.Next()->text, "d");
}

TEST(Tokenizer, ANulByteIsFoundWhereItStands) {
  using namespace std::string_literals;
  const Text text{"t", "a\r\nb\nab\0c"s};
  const auto error = FindNul(text);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->line, 3u);
  EXPECT_EQ(error->column, 3u);
  EXPECT_FALSE(FindNul(Text{"t", "abc"}));
}

}  // namespace
}  // namespace ray

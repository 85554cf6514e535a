#include <gtest/gtest.h>

#include <ctime>

#include "tests/source/parse/document/Documents.h"

namespace ray {
namespace {

TEST(JsonDocument, ContainsTheValuesOfTheText) {
  const Read read = Json(R"({"a": [1, -2.5e3, "x", true, null], "b": {"c": {}}, "": []})");
  EXPECT_EQ(Written(read.Root()), "{a:[1 -2.5e3 'x' true -] b:{c:{}} :[]}");
}

TEST(JsonDocument, EscapesAreReadInKeysAndStrings) {
  EXPECT_EQ(Written(Json(R"({"\u00e9\"": "\\\u0041\n"})").Root()), "{\xC3\xA9\":'\\A\n'}");
}

// The library reports no positions; a caret under the wrong word would mislead the reader.
TEST(JsonDocument, EveryValueAndKeyHasItsPosition) {
  const Read read = Json("\xEF\xBB\xBF{\r\n\t\"a\" : [ 1,\"\\\"]\" , -2.5 ],\r\n  \"\xC3\xA9\\\"\":{\"b\":null}\r\n}");
  const auto& root = read.Root().Entries();
  const auto place = [&](const Extent& extent) {
    const Token token = read.places->At(extent);
    return std::to_string(token.line) + ":" + std::to_string(token.column) + " " + std::string(token.text);
  };
  EXPECT_EQ(place(root[0].key_extent), "2:2 \"a\"");
  EXPECT_EQ(place(root[0].value.extent), "2:8 [");
  EXPECT_EQ(place(root[0].value.Entries()[0].value.extent), "2:10 1");
  EXPECT_EQ(place(root[0].value.Entries()[1].value.extent), "2:12 \"\\\"]\"");
  EXPECT_EQ(place(root[0].value.Entries()[2].value.extent), "2:20 -2.5");
  EXPECT_EQ(place(root[1].key_extent), "3:3 \"\xC3\xA9\\\"\"");
  EXPECT_EQ(place(root[1].value.Entries()[0].key_extent), "3:10 \"b\"");
  EXPECT_EQ(place(root[1].value.Entries()[0].value.extent), "3:14 null");
}

TEST(JsonDocument, APathLeadsToEveryValue) {
  const Read read = Json(R"({"Objects": [{}, {"material": {"kd": [1, 2]}}]})");
  const Value& objects = read.Root().Entries()[0].value;
  const Value& kd = objects.Entries()[1].value.Entries()[0].value.Entries()[0].value;
  EXPECT_EQ(read.document->PathOf(read.Root()), "");
  EXPECT_EQ(read.document->PathOf(objects), "Objects");
  EXPECT_EQ(read.document->PathOf(objects.Entries()[0].value), "Objects[0]");
  EXPECT_EQ(read.document->PathOf(kd), "Objects[1].material.kd");
  EXPECT_EQ(read.document->PathOf(kd.Entries()[1].value), "Objects[1].material.kd[1]");
}

TEST(JsonDocument, AsManyLevelsAsTheLimitAreRead) {
  constexpr std::size_t deepest = Document::max_depth;
  EXPECT_EQ(Json(Repeated("[", deepest) + Repeated("]", deepest)).message, "");
  EXPECT_TRUE(Contains(Json(Repeated("[", deepest + 1) + Repeated("]", deepest + 1)).message,
                       "a.json:1:101: error: nested deeper than 100 levels"));
}

// Code that recursed over a million levels would overflow the stack.
TEST(JsonDocument, AMillionLevelsAreRefusedAtOnce) {
  for (const char* level : {"[", "{\"a\":"}) {
    const std::clock_t start = std::clock();
    EXPECT_TRUE(Contains(Json(Repeated(level, 1'000'000)).message, "nested deeper than 100 levels")) << level;
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, patience) << level;
  }
}

TEST(JsonDocument, EveryDuplicateKeyIsReported) {
  const Read read = Json("{\"a\": 1,\n \"b\": {\"c\": 1, \"c\": 2},\n \"a\": 3}");
  EXPECT_EQ(Written(read.Root()), "{b:{c:2} a:3}");
  EXPECT_EQ(read.report.Warnings(),
            (std::vector<std::string>{
                "a.json:2:16: warning: duplicate key 'c', already given in line 2; the last one counts",
                "a.json:3:2: warning: duplicate key 'a', already given in line 1; the last one counts"}));
}

// Queried in the middle of a long line, like the only line of a file that a program wrote.
TEST(TextPlaces, CountsCharactersFromTheLinesBeginning) {
  const Text text{"a", "\xEF\xBB\xBF" + Repeated("\xC3\xA9", 10'000) + "\r\n" + Repeated("x", 10'000) + "\ry"};
  const TextPlaces places(text);
  const auto at = [&](std::size_t offset) {
    const Token token = places.At({offset, 1});
    return std::pair{token.line, token.column};
  };
  EXPECT_EQ(at(3), std::pair(std::size_t{1}, std::size_t{1}));
  EXPECT_EQ(at(3 + 2 * 7'000), std::pair(std::size_t{1}, std::size_t{7'001}));
  EXPECT_EQ(at(3 + 20'000 + 2 + 9'000), std::pair(std::size_t{2}, std::size_t{9'001}));
  EXPECT_EQ(at(3 + 20'000 + 2 + 10'001), std::pair(std::size_t{3}, std::size_t{1}));
  EXPECT_EQ(at(1'000'000), std::pair(std::size_t{3}, std::size_t{2})) << "behind the end";
}

}  // namespace
}  // namespace ray

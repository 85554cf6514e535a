#include <gtest/gtest.h>

#include <ctime>

#include "tests/source/parse/document/Documents.h"

namespace ray {
namespace {

#ifdef RAYPRO_YAML

TEST(YamlDocument, ContainsTheValuesOfTheText) {
  EXPECT_EQ(
      Written(
          Yaml("# remark\n---\na: [1, -2.5, x y, true]\nb:\n- c: 1\n  d: {e: 'f', \"g\": ~}\n-\n  - 2\nh:\n").Root()),
      "{a:[1 -2.5 x y true] b:[{c:1 d:{e:'f' g:-}} [2]] h:-}");
}

TEST(YamlDocument, EveryValueAndKeyHasItsPosition) {
  const Read read =
      Yaml("\xEF\xBB\xBF# \xC3\xA9\r\na: \xC3\xA9\xC3\xA9\r\nb: {\xC3\xA9: &x \"q\\\"r\", c: 'it''s'}\r\n- d\r\n");
  EXPECT_TRUE(Contains(read.message, "a.yaml:4:1: error: this line does not fit the indentation"));
  const Read good =
      Yaml("\xEF\xBB\xBF# \xC3\xA9\r\na: \xC3\xA9\xC3\xA9\r\nb: {\xC3\xA9: &x \"q\\\"r\", c: 'it''s', d: *x}\r\n");
  const auto place = [&](const Extent& extent) {
    const Token token = good.places->At(extent);
    return std::to_string(token.line) + ":" + std::to_string(token.column) + " " + std::string(token.text);
  };
  const auto& root = good.Root().Entries();
  EXPECT_EQ(place(root[0].value.extent), "2:4 \xC3\xA9\xC3\xA9");
  EXPECT_EQ(place(root[1].key_extent), "3:1 b");
  EXPECT_EQ(place(root[1].value.Entries()[0].key_extent), "3:5 \xC3\xA9");
  EXPECT_EQ(place(root[1].value.Entries()[0].value.extent), "3:11 \"q\\\"r\"");
  EXPECT_EQ(place(root[1].value.Entries()[1].value.extent), "3:22 'it''s'");
}

TEST(YamlDocument, AnAbsentValueIsReportedAtItsKey) {
  const Read read = Yaml("a: 1\nb:\nc: 2\n");
  EXPECT_EQ(read.places->At(read.Root().Entries()[1].value.extent).line, 2u);
}

TEST(YamlDocument, AnAliasStandsForTheValueOfItsAnchor) {
  const Read read = Yaml("a: &x {k: [1, 2]}\nb: *x\nc: [&y z, *y]\n");
  EXPECT_EQ(Written(read.Root()), "{a:{k:[1 2]} b:{k:[1 2]} c:[z z]}");
  const Value& copy = read.Root().Entries()[1].value;
  EXPECT_TRUE(copy.is_alias);
  EXPECT_EQ(copy.collection, read.Root().Entries()[0].value.collection) << "shared, not copied";
}

// "Billion laughs": nine lines that stand for a billion words.
TEST(YamlDocument, AliasesThatExplodeAreRefusedBeforeTheyTakeMemory) {
  std::string bytes = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    bytes += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + Repeated(before + ", ", 9) + before + "]\n";
  }
  const std::clock_t start = std::clock();
  const std::string message = Yaml(bytes).message;
  EXPECT_TRUE(Contains(message, "error: more than 16777216 values")) << message;
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 0.1 * patience);
}

TEST(YamlDocument, AMillionLevelsAreRefused) {
  for (const char* level : {"[", "- ", "{a: ", "{a: \n", "[\n", "? ", "[{a: "}) {
    const std::clock_t start = std::clock();  // of the processor: the machine may have other work
    EXPECT_NE(Yaml("- " + Repeated(level, 1'000'000)).message, "") << level;
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 4 * patience) << level;
  }
  constexpr std::size_t deepest = Document::max_depth;
  EXPECT_EQ(Yaml(Repeated("[", deepest) + Repeated("]", deepest)).message, "");
  EXPECT_TRUE(
      Contains(Yaml(Repeated("[", deepest + 1) + Repeated("]", deepest + 1)).message, "nested deeper than 100"));
}

TEST(YamlDocument, EveryDuplicateKeyIsReported) {
  const Read read = Yaml("a: 1\nb: 2\na: 3\na: 4\n");
  EXPECT_EQ(Written(read.Root()), "{a:1 b:2}");
  EXPECT_EQ(read.report.Warnings(),
            (std::vector<std::string>{
                "a.yaml:3:1: warning: duplicate key 'a', already given in line 1; the first one counts",
                "a.yaml:4:1: warning: duplicate key 'a', already given in line 3; the first one counts"}));
}

// https://yaml.org/type/merge.html, examples 4 to 7.
TEST(YamlDocument, AMergeKeyAddsWhatItsMappingsHave) {
  const std::string anchors = "- &center {x: 1, y: 2}\n- &left {x: 0, y: 2}\n- &big {r: 10}\n- &small {r: 1}\n";
  const auto last = [&](const std::string& item) { return Written(Yaml(anchors + "- " + item + "\n").Root()); };
  const std::string four = "[{x:1 y:2} {x:0 y:2} {r:10} {r:1} ";
  EXPECT_EQ(last("{<<: *center, r: 10, label: a}"), four + "{r:10 label:a x:1 y:2}]");
  EXPECT_EQ(last("{<<: [*center, *big], label: a}"), four + "{label:a x:1 y:2 r:10}]");
  EXPECT_EQ(last("{<<: [*big, *left, *small], x: 1, label: a}"), four + "{x:1 label:a r:10 y:2}]");
  EXPECT_TRUE(Contains(Yaml("a: {<<: 3}").message, "<< must be followed by a mapping"));
  EXPECT_TRUE(Contains(Yaml("a: {<<: [{b: 1}, 3]}").message, "<< must be followed by a mapping"));
}

TEST(YamlDocument, MergedEntriesCountWithinTheLimit) {
  std::string text = "- &m0 {a: 1, b: 2, c: 3}\n";
  for (int i = 1; i < 20; ++i)
    text += "- &m" + std::to_string(i) + " {x" + std::to_string(i) + ": *m" + std::to_string(i - 1) + ", y" +
            std::to_string(i) + ": *m" + std::to_string(i - 1) + ", <<: *m" + std::to_string(i - 1) + "}\n";
  EXPECT_TRUE(Contains(Yaml(text).message, "more than")) << Yaml(text).message;
}

TEST(YamlDocument, ASecondDocumentIsIgnoredWithAWarning) {
  const Read read = Yaml("---\na: 1\n---\nb: 2\n");
  EXPECT_EQ(Written(read.Root()), "{a:1}");
  EXPECT_EQ(read.report.Warnings(), std::vector<std::string>{"a.yaml:3:1: warning: a second document is ignored"});
}

TEST(YamlDocument, AnEmptyFileHasNoValue) {
  for (const char* bytes : {"", "# remark\n", "---\n", "~"}) EXPECT_EQ(Written(Yaml(bytes).Root()), "-") << bytes;
}

#else

TEST(YamlDocument, StatesWhatToInstallIfItCannotBeRead) {
  EXPECT_EQ(Yaml("a: 1").message,
            "a.yaml: error: this program was built without YAML; install libyaml-cpp-dev and build it again");
}

#endif

}  // namespace
}  // namespace ray

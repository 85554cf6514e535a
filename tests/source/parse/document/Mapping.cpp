#include "source/parse/document/Mapping.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/source/parse/document/Documents.h"

namespace ray {
namespace {

struct Heard {
  std::string errors;
  std::vector<std::string> warnings;
};

Heard Reading(const std::string& json, const std::function<void(Mapping&)>& read) {
  const Read document = Json(json);
  Report report;
  DocumentReport told(*document.document, report);
  Heard heard;
  try {
    auto mapping = Field(told, document.Root()).AsMapping("a ball");
    if (mapping) {
      read(*mapping);
      mapping->Finish();
    }
    report.ThrowErrors();
  } catch (const SceneErrors& errors) {
    heard.errors = errors.what();
  }
  heard.warnings = report.Warnings();
  return heard;
}

TEST(Mapping, GivesValuesByAnyOfTheirNames) {
  const Heard heard =
      Reading(R"({"radius": 2, "centre": [1, 2, 3], "on": "yes", "color": [0, 0.5, 1]})", [](Mapping& ball) {
        EXPECT_EQ(ball.NeedNumber({"r", "radius"}, positive), 2);
        EXPECT_EQ(ball.NeedPoint({"center", "centre"}), (R3::Point{1, 2, 3}));
        EXPECT_TRUE(ball.Bool({"on"}, false));
        EXPECT_EQ(ball.NeedColor({"color"}), (R2::Color{0, 0.5, 1}));
        EXPECT_EQ(ball.Number({"weight"}, any_number, 7), 7);
        EXPECT_TRUE(ball.IsGood());
      });
  EXPECT_EQ(heard.errors, "");
  EXPECT_TRUE(heard.warnings.empty());
}

TEST(Mapping, TakesEveryWordForTrueAndFalse) {
  for (const char* yes : {"true", "1", "\"yes\"", "\"on\"", "\"True\"", "\"YES\""})
    Reading("{\"a\": " + std::string(yes) + "}", [&](Mapping& m) { EXPECT_TRUE(m.Bool({"a"}, false)) << yes; });
  for (const char* no : {"false", "0", "\"no\"", "\"off\""})
    Reading("{\"a\": " + std::string(no) + "}", [&](Mapping& m) { EXPECT_FALSE(m.Bool({"a"}, true)) << no; });
}

TEST(Mapping, ReportsEveryMistakeWithItsPath) {
  const Heard heard =
      Reading("{\"radius\": -1,\n\"center\": [1, 2],\n\"color\": [0, \"x\", -1],\n\"on\": 2,\n\"count\": 1.5}",
              [](Mapping& ball) {
                ball.NeedNumber({"radius"}, positive);
                ball.NeedPoint({"center"});
                ball.NeedColor({"color"});
                ball.Bool({"on"}, false);
                ball.Whole({"count"}, 0, 0);
                EXPECT_FALSE(ball.IsGood());
              });
  for (const char* message : {"a.json:1:12: error: radius must be positive, got -1",
                              "a.json:2:11: error: center must be a list of three numbers, got a list of 2",
                              "a.json:3:14: error: color[1] must be a number, got 'x'",
                              "a.json:3:19: error: color[2] must not be negative, got -1",
                              "a.json:4:7: error: on must be true or false, got '2'",
                              "a.json:5:10: error: count must be a whole number, got '1.5'"})
    EXPECT_TRUE(Contains(heard.errors, message)) << message << "\n" << heard.errors;
}

TEST(Mapping, AKeyThatIsMissingMayBeMisspelled) {
  const auto read = [](Mapping& ball) { ball.NeedNumber({"radius", "size"}, positive); };
  EXPECT_EQ(Reading("{\"raduis\": 1}", read).errors,
            "a.json:1:2: error: unknown key 'raduis' in a ball\n"
            "    1 | {\"raduis\": 1}\n"
            "      |  ^~~~~~~~ did you mean 'radius'?");
  EXPECT_EQ(Reading("{\"x\": 1}", read).errors,
            "a.json:1:1: error: the scene lacks radius\n"
            "    1 | {\"x\": 1}\n"
            "      | ^ the key is radius or size");
}

TEST(Mapping, WarnsOnceOfEachUnknownKey) {
  const Read document = Json("[{\"a\": 1, \"colour\": 2}, {\"a\": 1, \"colour\": 2, \"z\": 3}]");
  Report report;
  DocumentReport told(*document.document, report);
  const auto fields = Field(told, document.Root()).List();
  ASSERT_TRUE(fields);
  for (const Field& field : *fields) {
    auto mapping = field.AsMapping("a ball");
    mapping->Number({"a"}, any_number, 0);
    mapping->Number({"color"}, any_number, 0);
    mapping->Finish();
  }
  EXPECT_EQ(report.Warnings(),
            (std::vector<std::string>{
                "a.json:1:11: warning: unknown key 'colour' in a ball is ignored; did you mean 'color'?",
                "a.json:1:47: warning: unknown key 'z' in a ball is ignored"}));
}

TEST(Mapping, TwoNamesOfOneKeyAreAMistake) {
  const Heard heard = Reading("{\"center\": 1, \"position\": 2}", [](Mapping& m) {
    m.Number({"position", "center"}, any_number, 0);
  });
  EXPECT_TRUE(Contains(heard.errors, "'center' means the same as 'position'")) << heard.errors;
}

TEST(Mapping, AChoiceIsMadeInAnyLetterCase) {
  static constexpr std::array<std::string_view, 2> shapes{"Sphere", "Triangle"};
  Reading("{\"shape\": \"sPHERE\"}", [](Mapping& m) { EXPECT_EQ(m.Need({"shape"})->Choice(shapes, "shapes"), 0u); });
  const Heard heard =
      Reading("{\"shape\": \"Spere\"}", [](Mapping& m) { m.Need({"shape"})->Choice(shapes, "shapes"); });
  EXPECT_TRUE(Contains(heard.errors, "shape is unknown: 'Spere'")) << heard.errors;
  EXPECT_TRUE(Contains(heard.errors, "did you mean 'Sphere'?")) << heard.errors;
}

TEST(Mapping, NumbersBeyondDoublesAndCoordinatesAreRefused) {
  const Heard heard = Reading("{\"a\": \"1e999\", \"b\": [0, 1e200, 0]}", [](Mapping& m) {
    m.Number({"a"}, any_number, 0);
    m.NeedVector({"b"});
  });
  EXPECT_TRUE(Contains(heard.errors, "a must fit a double, whose largest is 1.8e308, got '1e999'")) << heard.errors;
  EXPECT_TRUE(Contains(heard.errors, "b[1] must be from -1e+150 to 1e+150, got 1e200")) << heard.errors;
}

}  // namespace
}  // namespace ray

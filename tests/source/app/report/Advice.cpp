#include "source/app/report/Advice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "source/accelerate/Accelerator.h"
#include "source/app/options/OptionTable.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Has;

const std::string camera_above = "camera 0 2 6  0 -.3 -1  0 1 0  .5  .1 100\n";
const std::string soft_light = "area_light 1 1 1  0 4 1  0 -1 0  1  1 0 0\n";
const std::string ball =
    "material 0 0 0  .8 .8 .8  0 0 0  0 0 0  0 0 0  1 1 0\nbox 0  -4 -.1 -4  4 0 4\nsphere 0  0 .8 0  .8\n";

std::string AdviceOn(const std::string& scene, const std::vector<std::string>& words = {},
                     double seconds_to_start = 0.25) {
  const testing::TemporaryFolder folder;
  const ParsedScene parsed = Parse(testing::WriteFile(folder / "example.scn", camera_above + scene), {});
  RenderOptions options = RenderOptions();
  options.render.width = options.render.height = 24;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2)
    Store(*FindOption(Program::raypro, words[i]), std::vector{words[i + 1]}, options);
  const World world(parsed.scene);
  return Advice(world, *FindAcceleratorKind("bvh")->Make(world, {}), options, seconds_to_start);
}

TEST(Advice, OnlyOptionsThatAffectTheSceneAreTried) {
  const std::string soft = AdviceOn(soft_light + ball);
  EXPECT_TRUE(Has(soft, "\n-shadow_samples 1 ")) << soft;
  EXPECT_FALSE(Has(soft, "-lights") || Has(soft, "-max_depth") || Has(soft, "-strategy")) << soft;
  const std::string path = AdviceOn(soft_light + soft_light + ball, {"mode", "path", "strategy", "light"});
  EXPECT_TRUE(Has(path, "\n-lights one ") && Has(path, "\n-strategy mis ") && Has(path, "\n-max_depth 6 ")) << path;
  EXPECT_FALSE(Has(path, "-shadow_samples") || Has(path, "-min_luminance")) << path;
  std::string lights;
  for (int i = 0; i < 5; ++i) lights += soft_light;
  const std::string many = AdviceOn(lights + ball, {"mode", "path"});
  EXPECT_TRUE(Has(many, "\n-lights all ")) << many;
}

TEST(Advice, LightLostToTheDepthLimitIsReported) {
  // A white room lit by a lamp within it is much brighter after many bounces.
  const std::string room =
      "material 0 0 0  .9 .9 .9  0 0 0  0 0 0  0 0 0  1 1 0\npoint_light 3 3 3  0 1 0  1 0 0\n"
      "box 0  -9 -9 -9  9 9 9\n";
  const std::string text = AdviceOn(room, {"mode", "path", "max_depth", "1"});
  EXPECT_TRUE(Has(text, "With -max_depth 2 the image has ")) << text;
  EXPECT_TRUE(Has(text, "% more light")) << text;
  EXPECT_FALSE(Has(AdviceOn(soft_light + ball), "more light"));
}

TEST(Advice, AnImageWithoutNoiseIsReported) {
  EXPECT_TRUE(Has(AdviceOn("background .5 .5 .5\n"), "No noise was found"));
}

TEST(Advice, TheTargetIsTheRequestedErrorInItsUnit) {
  EXPECT_TRUE(Has(AdviceOn(soft_light + ball), " below 2/255:"));
  const std::string relative = AdviceOn(soft_light + ball, {"error", "3%"});
  EXPECT_TRUE(Has(relative, " below 3%:")) << relative;
  EXPECT_FALSE(Has(relative, "-error 2")) << relative;
}

/// A row of the table.
struct AdvisedRow {
  std::string settings;
  double seconds;
};

std::vector<AdvisedRow> RowsOf(const std::string& advice) {
  static const std::regex row(R"((as requested|-[\w -]*\w) +(?:[0-9.]+|never) +([0-9.]+|never))");
  std::vector<AdvisedRow> rows;
  std::istringstream lines(advice);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, row))
      rows.push_back({found[1], found[2] == "never" ? INFINITY : std::stod(found[2])});
  return rows;
}

TEST(Advice, TheRecommendationIsTheFastestOfItsRows) {
  std::string lights;
  for (int i = 0; i < 3; ++i) lights += soft_light;
  const std::string text = AdviceOn(lights + ball, {}, 0);
  const auto rows = RowsOf(text);
  ASSERT_GE(rows.size(), 5u) << text;
  const auto add = text.find("add: ");
  ASSERT_NE(add, std::string::npos) << text;
  const auto words = text.substr(add + 5, text.find('\n', add) - add - 5);
  const auto advised = std::ranges::find_if(rows, [&](const AdvisedRow& row) {
    return (row.settings == "as requested" ? "-error 2" : row.settings + " -error 2") == words || row.settings == words;
  });
  ASSERT_NE(advised, rows.end()) << text;
  constexpr double noticeable = 1.1, rounding = 1.1;  // of two digits
  EXPECT_LE(advised->seconds, noticeable * rounding * std::ranges::min(rows, {}, &AdvisedRow::seconds).seconds) << text;
}

TEST(Advice, SecondsCountFromTheStartOfTheProgram) {
  for (const AdvisedRow& row : RowsOf(AdviceOn(soft_light + ball, {}, 1000))) EXPECT_GE(row.seconds, 1000);
}

TEST(Advice, AnErrorOutOfReachOfTheSamplesIsReported) {
  const std::string text = AdviceOn(soft_light + ball, {"samples", "8", "mode", "path", "error", "0.01"});
  EXPECT_TRUE(Has(text, "as requested") && Has(text, "never")) << text;
}

}  // namespace
}  // namespace ray

// The error that raypro states, tested by running it.
#include <gtest/gtest.h>

#include "tests/source/app/Place.h"

namespace ray::testing {
namespace {

TEST(Claims, AreTheSameWithAReportAndInItsReplay) {
  NEEDS_THE_PROGRAM();
  const Place place;
  ASSERT_EQ(place.Run("reference.pfm", {"-mode", "path", "-samples", "64", "-seed", "9"}).status, 0);
  const auto claim = [&](const List& words) {
    const Finished done = RunProgram(With({place.Scene(), place / "a.pfm", "-width", "40", "-height", "30", "-mode",
                                           "path", "-reference", place / "reference.pfm"},
                                          words));
    const std::size_t begin = done.output.find("estimated error"), end = done.output.find(';', begin);
    return begin < end ? done.output.substr(begin, end - begin) : done.output + done.error;
  };
  const std::string plain = claim({"-samples", "16"});
  EXPECT_TRUE(Has(plain, "estimated error at most")) << plain;
  EXPECT_EQ(claim({"-samples", "16", "-report", place / "r.json"}), plain);
  EXPECT_EQ(claim({"-replay", place / "r.json"}), plain);
  const std::string decided = claim({"-error", "4", "-report", place / "e.json"});
  EXPECT_EQ(claim({"-error", "4"}), decided);
  EXPECT_EQ(claim({"-replay", place / "e.json"}), decided);
}

TEST(Claims, AreOfDisplayedValuesEvenIfTheFormatKeepsLight) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const auto claim = [&](const std::string& image) {
    const Finished done = RunProgram(
        {place.Scene(), place / image, "-width", "40", "-height", "30", "-samples", "8", "-srgb", "-error", ".001"});
    return done.output.substr(std::min(done.output.find("estimated error"), done.output.size()));
  };
  EXPECT_TRUE(Has(claim("a.png"), "/255"));
  EXPECT_EQ(claim("a.pfm"), claim("a.png"));
}

TEST(Claims, LocateCausticsThatNoPathMayHaveFound) {
  NEEDS_THE_PROGRAM();
  const Place place(
      "camera 0 3 4  0 -.6 -1  0 1 0  .4  .1 100\nmaterial 0 0 0  .5 .5 .5  0 0 0  0 0 0  0 0 0  1 1 0\n"
      "material 0 0 0  0 0 0  .8 .8 .8  0 0 0  0 0 0  1 1 0\nmaterial 0 0 0  0 0 0  0 0 0  0 0 0  6 6 6  1 1 0\n"
      "box 0  -3 -1 -3  3 0 3\nbox 1  -3 0 -3  3 3 -2.9\nsphere 2  0 4 0  .0001\n");
  const char* warning = "no path from a surface to a lamp by way of mirrors or glass was found";
  const Finished tells = place.Run("a.pfm", {"-mode", "path", "-samples", "4", "-error", "1"});
  EXPECT_TRUE(Has(tells.error, warning)) << tells.error;
  EXPECT_FALSE(Has(place.Run("a.pfm", {"-samples", "4", "-error", "1"}).error, warning)) << "light samples find all";
}

// Here the worst thousandth of the pixels is a quarter of them.
TEST(Outliers, CauseNoWarningInTinyImages) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished done = place.Run("a.ppm", {"-crop", "18", "14", "20", "16", "-error", "2"});
  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.error, "");
}

}  // namespace
}  // namespace ray::testing

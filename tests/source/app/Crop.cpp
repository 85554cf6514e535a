// Runs of raypro -crop.
#include <gtest/gtest.h>

#include "tests/source/app/Place.h"

namespace ray::testing {
namespace {

TEST(Crop, ADenoisedOneIsResumedAndReplayedToTheByte) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const List crop{"-crop", "9", "4", "20", "17", "-mode", "path", "-filter", "gaussian", "-denoise"};
  const auto run = [&](const std::string& image, const List& more) {
    const Finished done = place.Run(image, With(crop, more));
    EXPECT_EQ(done.status, 0) << done.error;
    return ReadFile(place / image);
  };
  const std::string at_once = run("a.pfm", {"-samples", "8", "-report", place / "r.json"});
  EXPECT_TRUE(run("b.pfm", {"-replay", place / "r.json"}) == at_once);
  EXPECT_FALSE(run("c.pfm", {"-samples", "4", "-keep_checkpoint"}) == at_once);
  EXPECT_TRUE(run("c.pfm", {"-samples", "8", "-resume"}) == at_once);
}

TEST(Crop, ExplainStatesWhetherItMatchesTheWhole) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const auto said_with = [&](const List& more) {
    const Finished done = RunProgram(With(
        {place.Scene(), place / "a.png", "-width", "40", "-height", "30", "-explain", "-crop", "9", "4", "20", "17"},
        more));
    EXPECT_EQ(done.status, 0) << done.error;
    const std::size_t begin = done.error.find("the crop: ");
    return begin == std::string::npos ? done.error : done.error.substr(begin, done.error.find('\n', begin) - begin);
  };
  EXPECT_EQ(said_with({}), "the crop: the same pixels, bit for bit, as in the whole image");
  EXPECT_EQ(said_with({"-samples", "2", "-denoise"}),
            "the crop: the same pixels, bit for bit, as in the whole image; 16 pixels around it are rendered too");
  EXPECT_EQ(said_with({"-error", "9"}), "the crop: not the pixels of the whole image, because of -error");
  EXPECT_EQ(said_with({"-error", "9", "-time", "1s"}),
            "the crop: not the pixels of the whole image, because of -time, -error");
}

}  // namespace
}  // namespace ray::testing

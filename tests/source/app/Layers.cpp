// Images of raypro -layers, and rayimg's work on them.
#include <gtest/gtest.h>

#include "tests/source/app/Place.h"

namespace ray::testing {
namespace {

const std::string scene_with_a_lamp_in_view =
    "camera 0 0 6  0 0 -1  0 1 0  0.4  0.1 100\nambient .2 .2 .2\npoint_light 1 .9 .7  1 1 0  1 0 0\n"
    "sphere -1  -1 0 0  1\n";

TEST(Layers, AFlareCanBeSubtractedFromTheImage) {
  NEEDS_THE_PROGRAM();
  if (!R2::FormatForName("a.exr")) GTEST_SKIP() << "without OpenEXR";
  const SceneFolder place(scene_with_a_lamp_in_view);
  const auto render = [&](const std::string& name, const List& more) {
    const Finished done = RunProgram(With({place.Scene(), place / name, "-width", "40", "-height", "30"}, more));
    EXPECT_EQ(done.status, 0) << done.error;
  };
  render("with.exr", {"-flare", "1", "-layers", "depth,flare"});
  render("without.exr", {"-layers", "depth"});
  const auto rayimg = [](const List& words) { return RunProgram(words, {.program = "RAYIMG"}); };
  const Finished info = rayimg({"info", place / "with.exr"});
  EXPECT_TRUE(Has(info.output, "layer flare: flare.R, flare.G, flare.B float")) << info.output;
  EXPECT_EQ(rayimg({"extract", place / "with.exr", "flare", place / "flare.pfm"}).status, 0);
  const R2::Image with = Decode(place / "with.exr").image, without = Decode(place / "without.exr").image,
                  flare = Decode(place / "flare.pfm").image;
  double most = 0;
  for (std::size_t i = 0; i < with.Channels().size(); ++i) {
    // One glare of eight discs: eight sums, each rounded to half a unit in the last place of a float.
    ASSERT_NEAR(with.Channels()[i] - flare.Channels()[i], without.Channels()[i], 8 * 0x1p-24 * with.Channels()[i]);
    most = std::max<double>(most, flare.Channels()[i]);
  }
  EXPECT_GT(most, 0.5);
}

}  // namespace
}  // namespace ray::testing

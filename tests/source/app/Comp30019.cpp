// Images of COMP30019's command line; tests/app/comp30019.txt has its messages and exit statuses.
#include <gtest/gtest.h>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

/// Returns the mean over each eighth of an image's width and height.
std::vector<double> Eighths(const R2::Image& image) {
  std::vector<double> means(64);
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x)
      means[static_cast<std::size_t>(8 * (8 * y / image.Height()) + 8 * x / image.Width())] +=
          64 * Luminance(image.At(x, y)) / image.Width() / image.Height();
  return means;
}

// Regression: emission was a radiance with -l, and surfaces that were bright without it were nearly black.
TEST(Comp30019Program, AmbientLightAddsToThatOfLamps) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const std::string scene = (project::Root() / "scenes/comp30019/lamps.txt").string();
  const auto shown = [&](const std::vector<std::string>& more) {
    const std::vector<std::string> words{"-as", "comp30019",        "-f", scene, "-o", folder / "out.png",
                                         "-w",  "64", "-h", "64"};
    EXPECT_EQ(RunProgram(With(words, more)).status, 0);
    return Eighths(Decode(folder / "out.png").image);
  };
  const std::vector<double> direct = shown({}), all = shown({"-l"});
  double sum = 0, direct_sum = 0;
  for (std::size_t i = 0; i < direct.size(); ++i) {
    EXPECT_GT(all[i], direct[i] - 0.02) << "darker in eighth " << i;  // noise
    sum += all[i], direct_sum += direct[i];
  }
  EXPECT_GT(sum, 1.5 * direct_sum) << "walls of albedo .75 around all sides reflect most of the light";
}

}  // namespace
}  // namespace ray::testing

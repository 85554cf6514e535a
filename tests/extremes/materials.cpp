// Exponents of highlights from none to the largest.

#include <gtest/gtest.h>

#include <cmath>

#include "source/parse/SceneError.h"
#include "tests/Project.h"

namespace {

/// A ball that has highlights and nothing else, lit from beside the camera.
R2::Image Highlight(const std::string& exponent) {
  const project::Stage stage(
      project::FromText("camera 0 0 5  0 0 -1  0 1 0  .3  .1 100\npoint_light 1 1 1  1 1 5  1 0 0\n"
                        "material 0 0 0  0 0 0  .5 .5 .5  0 0 0  0 0 0  " +
                        exponent + " 1 0\nsphere 0  0 0 0  1\n"));
  ray::RenderSettings settings = project::Sized(48);
  settings.trace.max_depth = 0;
  return project::Render(stage, settings).image;
}

TEST(Extremes, F1_HighlightsOfAnyExponentAreFinite) {
  double last = 1e9;
  for (const char* exponent : {"0", "0.5", "1", "1e3", "1e6", "1e300"}) {
    const R2::Image image = Highlight(exponent);
    double sum = 0;
    for (const float channel : image.Channels()) {
      ASSERT_TRUE(std::isfinite(channel)) << exponent;
      ASSERT_GE(channel, 0) << exponent;
      ASSERT_LE(channel, 0.5F) << exponent;
      sum += channel;
    }
    EXPECT_LT(sum, last) << exponent << ": higher exponents make smaller highlights";
    EXPECT_TRUE(sum > 0 || std::string(exponent) != "1e3");
    last = sum + 1e-12;
    if (std::string(exponent) != "0") continue;
    for (const float channel : image.Channels()) EXPECT_TRUE(channel == 0 || channel == 0.5F) << "x^0 is 1";
  }
}

TEST(Extremes, F1_ANegativeExponentIsAnError) { EXPECT_THROW(Highlight("-1"), ray::SceneErrors); }

}  // namespace

// The conversion of samples to an image: clamping, and rounding to bytes.
#include <gtest/gtest.h>

#include "R2/ImageFile.h"
#include "tests/Project.h"

namespace ray {
namespace {

/// Renders a pixel half of which shines at 4; the other half is black.
R2::Color HalfBright(Clamp clamp) {
  RenderSettings settings = project::Sized(1);
  settings.samples = 4;
  settings.trace.sampler = SamplerKind::grid;
  settings.clamp = clamp;
  return project::Render(project::Stage(project::FromText(
                             "camera 0 0 5  0 0 -1  0 1 0  0.5  0.01 100 dir_light 0 0 0 0 0 -1 "
                             "material 0 0 0  0 0 0  0 0 0  0 0 0  4 4 .5  10 1 0 box 0  0 -9 0  9 9 1")),
                         settings)
      .image.At(0, 0);
}

TEST(ImageRules, SamplesAreClampedBeforeAveragingOnRequest) {
  EXPECT_EQ(HalfBright(Clamp::image), (R2::Color{2, 2, 0.25}));
  EXPECT_EQ(HalfBright(Clamp::samples), (R2::Color{0.5, 0.5, 0.25}));
}

TEST(ImageRules, BytesAreRoundedOrTruncated) {
  using enum R2::Quantization;
  EXPECT_EQ(R2::ToByte(0.999), 255);
  EXPECT_EQ(R2::ToByte(0.999, truncated), 254);
  EXPECT_EQ(R2::ToByte(1, truncated), 255);
  EXPECT_EQ(R2::ToByte(7, truncated), 255);
  EXPECT_EQ(R2::ToByte(-1, truncated), 0);
  EXPECT_EQ(R2::ToShort(0.5, truncated), 32767);
  for (int byte = 0; byte <= 255; ++byte) EXPECT_EQ(R2::ToByte(byte / 255.0, truncated), byte);
}

// The image contains floats, which may round a value up to the next byte.
TEST(ImageRules, ATruncatedByteIsThatOfTheExactValue) {
  Film rounded(256, 1, {0, 0, 256, 1}, FilterKind::box);
  const Filter filter(FilterKind::box);
  for (int i = 0; i < rounded.Blocks(); ++i) {
    Film::Block& block = rounded[i];
    block.sums[0] = rounded.EmptySums(i);
    block.samples[0] = 1;
    const PixelRectangle pixels = rounded.PixelsOf(i);
    for (int x = pixels.x0; x < pixels.x1; ++x) {
      const double below = std::nextafter(x / 255.0, 0);
      block.sums[0].Add(x, 0, x + 0.5, 0.5, {below, x / 255.0, x * (1 - 1e-9) / 255}, filter);
    }
  }
  const R2::Image image = rounded.Image(R2::Quantization::truncated);
  const auto byte = [](double v) { return static_cast<int>(R2::ToByte(v, R2::Quantization::truncated)); };
  for (int x = 1; x < 256; ++x) {
    const R2::Color c = image.At(x, 0);
    EXPECT_EQ(byte(c.r), byte(std::nextafter(x / 255.0, 0))) << x;
    EXPECT_EQ(byte(c.g), x);
    EXPECT_EQ(byte(c.b), x - 1);
  }
}

TEST(ImageRules, AShadowBiasLetsNearThingsCastNoShadow) {
  const auto seen = [](const std::string& bias) {
    // A blocker 0.1 above the floor, which the camera sees from below it.
    return project::Render(project::Stage(project::FromText(
                               bias + " camera 0 .05 0  0 -1 0  0 0 1  0.5  0.01 100 dir_light 1 1 1 0 -1 0 "
                                      "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  10 1 0 "
                                      "box 0  -9 -1 -9  9 0 9 box 0  -9 .1 -9  9 .2 9")),
                           project::Sized(1))
        .image.At(0, 0)
        .r;
  };
  EXPECT_EQ(seen(""), 0);
  EXPECT_EQ(seen("shadow_bias .05"), 0);
  EXPECT_EQ(seen("shadow_bias .3"), 1);
}

TEST(ImageRules, AShadowBiasHidesNearThingsBehindAnyGlass) {
  const auto seen = [](const std::string& bias, const std::string& index) {
    // A light 0.1 behind a pane.
    return project::Render(project::Stage(project::FromText(
                               bias +
                               " camera 0 0 5  0 0 -1  0 1 0  .1  0.01 100 point_light 0 0 0  0 0 0  1 0 0 "
                               "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  1 " +
                               index +
                               " 0 "
                               "material 0 0 0  0 0 0  0 0 0  0 0 0  .5 0 0  1 1 0 "
                               "disc 0  0 0 0  0 0 1  1 disc 1  0 0 -.1  0 0 1  1")),
                           project::Sized(1))
        .image.At(0, 0)
        .r;
  };
  for (const std::string index : {"1", "1.000001"}) {
    EXPECT_EQ(seen("", index), 0.5) << index;
    EXPECT_EQ(seen("shadow_bias .05", index), 0.5) << index;
    EXPECT_EQ(seen("shadow_bias .3", index), 0) << index;
  }
}

}  // namespace
}  // namespace ray

// The files that rayimg resize, crop, side-by-side, contact-sheet and extract write.
#include <gtest/gtest.h>

#include "source/film/Resize.h"
#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

/// An image whose pixels are all different bytes.
R2::Image Distinct(int width, int height) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.Set(x, y, {(7 * x + 1) / 255.0, (11 * y + 2) / 255.0, (x + 16 * y) / 255.0});
  return image;
}

double MeanOf(const R2::Image& image) {
  double sum = 0;
  for (const float channel : image.Channels()) sum += channel;
  return sum / static_cast<double>(image.Channels().size());
}

// The box filter weights by area, so that it keeps the total light at all sizes.
TEST(Resize, ABoxKeepsTheMean) {
  const R2::Image image = Distinct(13, 9);
  for (const auto& [width, height] : {std::pair{5, 4}, {1, 1}, {26, 18}, {40, 3}}) {
    const R2::Image resized = Resized(image, width, height, FilterKind::box);
    EXPECT_EQ(resized.Width(), width);
    EXPECT_EQ(resized.Height(), height);
    EXPECT_NEAR(MeanOf(resized), MeanOf(image), 1e-6) << width << "x" << height;
  }
}

TEST(Resize, EveryFilterKeepsOneColor) {
  const R2::Image image = Filled(12, 7, {0.25, 0.5, 2});
  for (std::size_t kind = 0; kind < filter_names.size(); ++kind) {
    const R2::Image resized = Resized(image, 5, 20, static_cast<FilterKind>(kind));
    for (std::size_t i = 0; i < resized.Channels().size(); ++i)
      EXPECT_NEAR(resized.Channels()[i], image.Channels()[i % 3], 1e-6) << filter_names[kind];
  }
}

// Black and white average to light of a half, which sRGB encodes as 188 of 255; without -srgb to 127.5.
TEST(RayimgResize, AveragesLight) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  R2::Image image = Filled(2, 1, {});
  image.Set(1, 0, {1, 1, 1});
  const std::string in = Save(folder / "in.png", image), out = folder / "out.png";
  ASSERT_EQ(Rayimg({"resize", in, out, "-width", "1", "-height", "1", "-srgb"}).status, 0);
  EXPECT_NEAR(255 * Decode(out).image.At(0, 0).g, 188, 0.01);
  ASSERT_EQ(Rayimg({"resize", in, out, "-width", "1", "-height", "1"}).status, 0);
  EXPECT_NEAR(255 * Decode(out).image.At(0, 0).g, 127.5, 0.51);
}

TEST(RayimgResize, OneSideKeepsTheShapeAndFloatsStayFloats) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string in = Save(folder / "in.pfm", Filled(40, 20, {-1, 0.5, 300})), out = folder / "out.pfm";
  ASSERT_EQ(Rayimg({"resize", in, out, "-height", "5"}).status, 0);
  EXPECT_EQ(Decode(out).image, Filled(10, 5, {-1, 0.5, 300}));
}

TEST(RayimgCrop, PartsSideBySideAreTheWhole) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string in = Save(folder / "in.png", Distinct(13, 9));
  const std::string left = folder / "left.png", right = folder / "right.png", out = folder / "out.png";
  ASSERT_EQ(Rayimg({"crop", in, left, "-crop", "0", "0", "5", "9"}).status, 0);
  ASSERT_EQ(Rayimg({"crop", in, right, "-crop", "5", "0", "13", "9"}).status, 0);
  EXPECT_EQ(Decode(left).image.At(4, 8), Decode(in).image.At(4, 8));
  ASSERT_EQ(Rayimg({"side-by-side", left, right, "-out", out}).status, 0);
  EXPECT_EQ(Decode(out).image, Decode(in).image);
  const std::string low = folder / "low.png", high = folder / "high.png";
  ASSERT_EQ(Rayimg({"crop", in, low, "-crop", "0", "0", "13", "4"}).status, 0);
  ASSERT_EQ(Rayimg({"crop", in, high, "-crop", "0", "4", "13", "9"}).status, 0);
  ASSERT_EQ(Rayimg({"side-by-side", high, low, "-columns", "1", "-out", out}).status, 0);
  EXPECT_EQ(Decode(out).image, Decode(in).image);
}

TEST(RayimgSideBySide, CaptionsAreBelowAndLeaveTheImagesAlone) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string in = Save(folder / "in.png", Distinct(30, 9)), out = folder / "out.png";
  ASSERT_EQ(Rayimg({"side-by-side", in, in, "-captions", "ab,", "-out", out}).status, 0);
  const R2::Image sheet = Decode(out).image, original = Decode(in).image;
  ASSERT_EQ(sheet.Width(), 60);
  const int below = sheet.Height() - 9;
  ASSERT_GT(below, 8);
  std::size_t ink_left = 0, ink_right = 0;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < below; ++y) (x < 30 ? ink_left : ink_right) += sheet.At(x, y).g < 0.5;
    for (int y = 0; y < 9; ++y) EXPECT_EQ(sheet.At(x, below + y), original.At(x % 30, y));
  }
  EXPECT_GT(ink_left, 10u);
  EXPECT_EQ(ink_right, 0u);
}

TEST(RayimgContactSheet, ShowsAFolderWithACrossForUnreadableFiles) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  Save(folder / "a.png", Filled(40, 20, {0, 1, 0}));
  WriteFile(folder / "b.png", "no image");
  WriteFile(folder / "notes.txt", "no image either");
  const std::string out = folder / "sheet.png";
  for (int run = 0; run < 2; ++run) {  // the sheet does not contain itself
    const Finished done = Rayimg({"contact-sheet", folder.Path().string(), "-out", out, "-width", "20", "-gap", "2"});
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(Has(done.error, "b.png: error: unknown image format")) << done.error;
    const R2::Image sheet = Decode(out).image;
    EXPECT_EQ(sheet.Width(), 2 + 20 + 2 + 20 + 2);
    EXPECT_EQ(sheet.At(12, sheet.Height() - 12), (R2::Color{0, 1, 0}));
    EXPECT_EQ(sheet.At(12, sheet.Height() - 4), (R2::Color{1, 1, 1})) << "shrunk to 20 x 10";
  }
}

// --- layers ---

std::string SaveLayers(const std::string& file) {
  const std::vector<R2::ImageLayer> layers{{{"N.X", "N.Y", "N.Z"}, Filled(6, 4, {0.5, -0.25, 1})},
                                           {{"Z"}, Filled(6, 4, {7, 0, 0})}};
  const auto bytes = R2::FormatForName("a.exr")->encode_layers(Distinct(6, 4), layers, {});
  return WriteFile(file, {bytes.begin(), bytes.end()});
}

TEST(RayimgLayers, AreListedExtractedAndCropped) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "this build has no EXR";
  const TemporaryFolder folder;
  const std::string in = SaveLayers(folder / "in.exr"), out = folder / "out.pfm", part = folder / "part.exr";
  const std::string info = Rayimg({"info", in}).output;
  EXPECT_TRUE(Has(info, "data window: 0 0 to 5 3\nlayer color: R, G, B float\nlayer N: N.X, N.Y, N.Z float\n")) << info;
  ASSERT_EQ(Rayimg({"crop", in, part, "-crop", "1", "1", "3", "4"}).status, 0);
  for (const auto& [name, color] :
       {std::pair<std::string, R2::Color>{"N", {0.5, -0.25, 1}}, {"Z", {7, 7, 7}}, {"N.Y", {-0.25, -0.25, -0.25}}}) {
    ASSERT_EQ(Rayimg({"extract", in, name, out}).status, 0) << name;
    EXPECT_EQ(Decode(out).image, Filled(6, 4, color)) << name;
    ASSERT_EQ(Rayimg({"extract", part, name, out}).status, 0) << name;
    EXPECT_EQ(Decode(out).image, Filled(2, 3, color)) << name;
  }
  ASSERT_EQ(Rayimg({"extract", in, "color", out}).status, 0);
  EXPECT_EQ(Decode(out).image, Distinct(6, 4));
}

TEST(RayimgLayers, AMissingOneIsAnsweredWithTheExistingOnes) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "this build has no EXR";
  const TemporaryFolder folder;
  const std::string in = SaveLayers(folder / "in.exr");
  const Finished done = Rayimg({"extract", in, "normal", folder / "out.pfm"});
  EXPECT_EQ(done.status, 2);
  EXPECT_TRUE(Has(done.error, "has no layer 'normal'; did you mean 'N'? (its layers: color, N, Z)")) << done.error;
  EXPECT_EQ(Rayimg({"extract", in, "N", folder / "out.png"}).status, 2);
  const Finished resized = Rayimg({"resize", in, folder / "small.exr", "-width", "3"});
  EXPECT_EQ(resized.status, 0);
  EXPECT_TRUE(Has(resized.error, "further layers, which are skipped: N, Z")) << resized.error;
}

}  // namespace
}  // namespace ray::rayimg

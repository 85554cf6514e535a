// Measurements and maps of rayimg diff; tests/app/images.txt has its messages and exit statuses.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

// 40 x 40 pixels, +-0.25 by two independent checkerboards: the product is exactly the error of 0.125^2.
TEST(RayimgDiff, ASecondReferenceRemovesTheNoiseOfTheFirst) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  R2::Image r1(40, 40), r2(40, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const double first = x % 2 ? 0.75 : 0.25, second = y % 2 ? 0.75 : 0.25;
      r1.Set(x, y, {first, first, first});
      r2.Set(x, y, {second, second, second});
    }
  const Finished done = Rayimg({"diff", "-json", Save(folder / "x.pfm", Filled(40, 40, {0.625, 0.625, 0.625})),
                                Save(folder / "r1.pfm", r1), "-reference2", Save(folder / "r2.pfm", r2)});
  const auto json = nlohmann::json::parse(done.output, nullptr, false);
  EXPECT_DOUBLE_EQ(json["rmse"], std::sqrt(0.0625 + 0.015625));
  EXPECT_DOUBLE_EQ(json["two_reference_mse"], 0.015625);
  EXPECT_DOUBLE_EQ(json["two_reference_rmse"], 0.125);
}

TEST(RayimgDiff, TheMapIsBrightWhereTheImagesDiffer) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  R2::Image image = Filled(40, 20, {});
  const std::string r = Save(folder / "r.png", image);
  for (int y = 0; y < 20; ++y)
    for (int x = 30; x < 40; ++x) image.Set(x, y, {0, 0, 0.6});
  const std::string x = Save(folder / "x.png", image), map = folder / "map.pfm";
  ASSERT_EQ(Rayimg({"diff", x, r, "-map", map, "-map_of", "display"}).status, 0);
  const R2::Image display = Decode(map).image;
  EXPECT_EQ(display.At(5, 10), (R2::Color{0, 0, 0}));
  EXPECT_NEAR(R2::Luminance(display.At(35, 10)), 0.6, 0.002);
  ASSERT_EQ(Rayimg({"diff", x, r, "-map", map}).status, 0);
  const R2::Image flip = Decode(map).image;
  EXPECT_LT(R2::Luminance(flip.At(5, 10)), 0.001);
  EXPECT_GT(R2::Luminance(flip.At(38, 10)), 0.5);
}

}  // namespace
}  // namespace ray::rayimg

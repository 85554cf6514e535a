// Measurements of rayimg diff, and its exit statuses.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

nlohmann::json DiffJson(Words words) {
  words.insert(words.begin(), {"diff", "-json"});
  return nlohmann::json::parse(Rayimg(words).output, nullptr, false);
}

// --- diff ---

TEST(RayimgDiff, PrintsItsMeasurements) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  R2::Image image = Filled(8, 4, {0.25, 0.25, 0.25});
  const std::string reference = Save(folder / "r.pfm", image);
  image.Set(5, 2, {0.25, 0.75, 0.25});
  const Finished done = Rayimg({"diff", Save(folder / "x.pfm", image), reference});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.error, "");
  EXPECT_TRUE(Has(done.output, "largest         0.5 at 5 2, channel g\n")) << done.output;
  EXPECT_TRUE(Has(done.output, "linear RMSE     0.051031\n")) << done.output;  // sqrt(0.25 / 96)
  EXPECT_TRUE(Has(done.output, "bias            r 0, g 0.015625, b 0\n")) << done.output;

  const auto json = DiffJson({folder / "x.pfm", reference});
  EXPECT_DOUBLE_EQ(json["rmse"], std::sqrt(0.25 / 96));
  EXPECT_DOUBLE_EQ(json["relative_mse"], 0.25 / 0.0725 / 96);
  EXPECT_DOUBLE_EQ(json["display_rmse"], 255 * std::sqrt(0.25 / 96));
  EXPECT_DOUBLE_EQ(json["psnr"], 10 * std::log10(96 / 0.25));
  EXPECT_EQ(json["largest"]["x"], 5);
  EXPECT_EQ(json["largest"]["y"], 2);
  EXPECT_EQ(json["largest"]["channel"], "g");
  EXPECT_EQ(json["bias"], nlohmann::json({0.0, 0.015625, 0.0}));
  EXPECT_GT(json["flip"], 0);
}

TEST(RayimgDiff, EqualImagesPassEveryThresholdOfZero) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.png", Filled(9, 9, {0.2, 0.4, 0.6}));
  EXPECT_EQ(Rayimg({"diff", a, a, "-fail", "0", "-fail_rmse", "0", "-fail_flip", "0"}).status, 0);
  EXPECT_TRUE(DiffJson({a, a})["psnr"].is_null()) << "JSON holds no infinity";
}

// One pixel of eight differs by 0.5.
TEST(RayimgDiff, ExitStatusAndMessageNameTheExceededThreshold) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  R2::Image image = Filled(4, 2, {0.25, 0.25, 0.25});
  const std::string r = Save(folder / "r.pfm", image);
  image.Set(1, 1, {0.75, 0.25, 0.25});
  const std::string x = Save(folder / "x.pfm", image);
  const struct {
    Words options;
    int status;
    const char* words;
  } cases[] = {
      {{}, 0, "linear RMSE"},
      {{"-fail", "0.5"}, 0, "beyond 0.5      0 pixels, 0%\n"},
      {{"-fail", "0.49"}, 1, "fails: 12.5% of the pixels differ by more than 0.49, allowed are 0%\n"},
      {{"-fail", "0.49", "-fail_percent", "12.4"}, 1, "allowed are 12.4%"},
      {{"-fail", "0.49", "-fail_percent", "12.5"}, 0, "beyond 0.49     1 pixel, 12.5%\n"},
      {{"-fail_rmse", "0.11"}, 0, ""},  // sqrt(0.25 / 24) = 0.102
      {{"-fail_rmse", "0.1"}, 1, "fails: linear RMSE 0.102062 is above 0.1\n"},
      {{"-fail_flip", "1"}, 0, ""},
      {{"-fail_flip", "0.001"}, 1, "fails: FLIP "},
  };
  for (const auto& [options, status, words] : cases) {
    Words all{"diff", x, r};
    all.insert(all.end(), options.begin(), options.end());
    const Finished done = Rayimg(all);
    EXPECT_EQ(done.status, status) << done.output << done.error;
    EXPECT_TRUE(Has(done.output, words)) << done.output;
    EXPECT_EQ(Has(done.output, "fails:"), status == 1) << done.output;
    all.emplace_back("-json");
    const Finished as_json = Rayimg(all);
    EXPECT_EQ(as_json.status, status);
    EXPECT_EQ(nlohmann::json::parse(as_json.output)["failures"].empty(), status == 0) << as_json.output;
  }
}

// A renderer that writes NaN must fail every test of its images.
TEST(RayimgDiff, PixelsThatAreNotFiniteFailEveryThreshold) {
  NEEDS_RAYIMG();
  for (const char* format : {"pfm", "exr"}) {
    if (!HasExr() && std::string(format) == "exr") continue;
    const TemporaryFolder folder;
    R2::Image image = Filled(4, 2, {0.25, 0.25, 0.25});
    const std::string r = Save(folder / ("r." + std::string(format)), image);
    image.Set(0, 0, {nan, 0.25, 0.25});
    image.Set(1, 0, {0.25, infinity, 0.25});
    const std::string x = Save(folder / ("x." + std::string(format)), image);
    for (const Words& option : {Words{"-fail", "1000"}, {"-fail_rmse", "1000"}, {"-fail_flip", "1"}}) {
      const Finished done = Rayimg({"diff", x, r, option[0], option[1]});
      EXPECT_EQ(done.status, 1) << format << option[0] << done.output << done.error;
      EXPECT_TRUE(Has(done.output, "not finite      2 pixels")) << done.output;
    }
    const Finished plain = Rayimg({"diff", x, r});
    EXPECT_EQ(plain.status, 0);
    EXPECT_TRUE(Has(plain.output, "linear RMSE     0\n")) << plain.output;
  }
}

// Light of 0.5 is written as 188 of 255 with the sRGB curve: read back, it is the same light.
TEST(RayimgDiff, WithSrgbALinearImageEqualsItsEncodedFile) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string light = Save(folder / "light.pfm", Filled(5, 5, {0.5, 0.5, 0.5}));
  const double encoded = 188 / 255.0;
  const std::string shown = Save(folder / "shown.png", Filled(5, 5, {encoded, encoded, encoded}));
  EXPECT_LT(DiffJson({light, shown, "-srgb"})["rmse"], 0.003);
  EXPECT_LT(DiffJson({light, shown, "-srgb"})["display_rmse"], 0.5);
  EXPECT_GT(DiffJson({light, shown})["rmse"], 0.2);
}

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
  const auto json = DiffJson({Save(folder / "x.pfm", Filled(40, 40, {0.625, 0.625, 0.625})),
                              Save(folder / "r1.pfm", r1), "-reference2", Save(folder / "r2.pfm", r2)});
  EXPECT_DOUBLE_EQ(json["rmse"], std::sqrt(0.0625 + 0.015625));
  EXPECT_DOUBLE_EQ(json["two_reference_mse"], 0.015625);
  EXPECT_DOUBLE_EQ(json["two_reference_rmse"], 0.125);
}

TEST(RayimgDiff, ANegativeProductHasNoRoot) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const Words words{Save(folder / "x.pfm", Filled(2, 2, {0.5, 0.5, 0.5})),
                    Save(folder / "r1.pfm", Filled(2, 2, {0.25, 0.25, 0.25})), "-reference2",
                    Save(folder / "r2.pfm", Filled(2, 2, {1, 1, 1}))};
  EXPECT_EQ(DiffJson(words)["two_reference_mse"], -0.125);
  EXPECT_TRUE(DiffJson(words)["two_reference_rmse"].is_null());
}

TEST(RayimgDiff, WarnsOfOrRefusesReferencesThatShareNoise) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "no EXR in this build";
  const TemporaryFolder folder;
  const R2::Image image = Filled(2, 2, {0.5, 0.5, 0.5});
  const std::string x = Save(folder / "x.exr", image, {{"seed", "1"}, {"scene_hash", "ab"}, {"samples", "4"}});
  const std::string r = Save(folder / "r.exr", image, {{"seed", "1"}, {"scene_hash", "ab"}, {"samples", "64"}});
  const std::string other = Save(folder / "o.exr", image, {{"seed", "2"}, {"scene_hash", "ab"}, {"samples", "64"}});
  EXPECT_TRUE(Has(Rayimg({"diff", x, r}).error, "both have seed '1'"));
  EXPECT_EQ(Rayimg({"diff", x, other}).error, "");
  EXPECT_EQ(Rayimg({"diff", x, x}).error, "") << "the same image again is meant to be the same";
  EXPECT_EQ(Rayimg({"diff", x, other, "-reference2", r}).status, 2);
  EXPECT_EQ(Rayimg({"diff", x, other, "-reference2", other}).status, 2);
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

// --- info ---

}  // namespace
}  // namespace ray::rayimg

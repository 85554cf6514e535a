// rayimg from outside: what it measures and writes, and what it says of wrong input; and its tables, which the help,
// the manual, the completions and docs/options.md repeat.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "R2/Color.h"
#include "R2/ImageFile.h"
#include "source/app/options/Completion.h"
#include "source/app/options/Help.h"
#include "source/app/options/Manual.h"
#include "source/app/options/RayimgTable.h"
#include "tests/source/app/Program.h"

namespace ray::rayimg {
namespace {

using testing::Finished;
using testing::Has;
using testing::ReadFile;
using testing::TemporaryFolder;
using testing::WriteFile;
using Words = std::vector<std::string>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const Words nothing;
constexpr Program program = Program::rayimg;

Finished Rayimg(const Words& words) { return testing::RunProgram(words, {.program = "RAYIMG"}); }

R2::Image Filled(int width, int height, const R2::Color& c) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.Set(x, y, c);
  return image;
}

/// Writes a picture in the format of its name, and returns the name.
std::string Save(const std::string& file, const R2::Image& image, const R2::ImageSettings& settings = {}) {
  const auto bytes = R2::FormatForName(file)->encode(image, {}, settings);
  return WriteFile(file, {bytes.begin(), bytes.end()});
}

R2::DecodedImage Decode(const std::string& file) {
  const std::string bytes = ReadFile(file);
  return R2::DecodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

/// The only format of floats that keeps settings may be missing from this build.
bool HasExr() { return R2::FormatForName("a.exr") != nullptr; }

nlohmann::json DiffJson(Words words) {
  words.insert(words.begin(), {"diff", "-json"});
  return nlohmann::json::parse(Rayimg(words).output, nullptr, false);
}

// --- diff ---

TEST(RayimgDiff, PrintsWhatItMeasures) {
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

TEST(RayimgDiff, EqualPicturesPassEveryThresholdOfZero) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.png", Filled(9, 9, {0.2, 0.4, 0.6}));
  EXPECT_EQ(Rayimg({"diff", a, a, "-fail", "0", "-fail_rmse", "0", "-fail_flip", "0"}).status, 0);
  EXPECT_TRUE(DiffJson({a, a})["psnr"].is_null()) << "JSON holds no infinity";
}

// One pixel of eight differs by 0.5.
TEST(RayimgDiff, ExitStatusAndWordsSayWhichThresholdIsExceeded) {
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
      {{"-fail", "0.5"}, 0, "beyond 0.5      0 pixels, 0 %\n"},
      {{"-fail", "0.49"}, 1, "fails: 12.5 % of the pixels differ by more than 0.49, allowed are 0 %\n"},
      {{"-fail", "0.49", "-fail_percent", "12.4"}, 1, "allowed are 12.4 %"},
      {{"-fail", "0.49", "-fail_percent", "12.5"}, 0, "beyond 0.49     1 pixel, 12.5 %\n"},
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

// A renderer that writes NaN must not slip through any test of its pictures.
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
TEST(RayimgDiff, WithSrgbALinearPictureEqualsItsEncodedFile) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string light = Save(folder / "light.pfm", Filled(5, 5, {0.5, 0.5, 0.5}));
  const double encoded = 188 / 255.0;
  const std::string shown = Save(folder / "shown.png", Filled(5, 5, {encoded, encoded, encoded}));
  EXPECT_LT(DiffJson({light, shown, "-srgb"})["rmse"], 0.003);
  EXPECT_LT(DiffJson({light, shown, "-srgb"})["display_rmse"], 0.5);
  EXPECT_GT(DiffJson({light, shown})["rmse"], 0.2);
}

// 40 x 40 pixels, +-0.25 by two checkerboards that are independent: the product is exactly the error of 0.125^2.
TEST(RayimgDiff, ASecondReferenceTakesTheNoiseOfTheFirstOut) {
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

TEST(RayimgDiff, AReferenceThatSharesItsNoiseIsRefusedOrWarnedOf) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "no EXR in this build";
  const TemporaryFolder folder;
  const R2::Image image = Filled(2, 2, {0.5, 0.5, 0.5});
  const std::string x = Save(folder / "x.exr", image, {{"seed", "1"}, {"scene_hash", "ab"}, {"samples", "4"}});
  const std::string r = Save(folder / "r.exr", image, {{"seed", "1"}, {"scene_hash", "ab"}, {"samples", "64"}});
  const std::string other = Save(folder / "o.exr", image, {{"seed", "2"}, {"scene_hash", "ab"}, {"samples", "64"}});
  EXPECT_TRUE(Has(Rayimg({"diff", x, r}).error, "both have seed '1'"));
  EXPECT_EQ(Rayimg({"diff", x, other}).error, "");
  EXPECT_EQ(Rayimg({"diff", x, x}).error, "") << "the same picture again is meant to be the same";
  EXPECT_EQ(Rayimg({"diff", x, other, "-reference2", r}).status, 2);
  EXPECT_EQ(Rayimg({"diff", x, other, "-reference2", other}).status, 2);
}

TEST(RayimgDiff, TheMapIsBrightWhereThePicturesDiffer) {
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

TEST(RayimgInfo, TellsStatisticsAndSettings) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  R2::Image image = Filled(2, 2, {0.5, 1, 0});
  image.Set(0, 0, {nan, -1, 0});
  image.Set(1, 1, {1.5, 1, infinity});
  const Finished pfm = Rayimg({"info", Save(folder / "a.pfm", image)});
  EXPECT_EQ(pfm.status, 0);
  EXPECT_TRUE(Has(pfm.output, "a.pfm: pfm, 2x2\n")) << pfm.output;
  EXPECT_TRUE(Has(pfm.output, "r: min 0.5, mean 0.833333, max 1.5\n")) << pfm.output;
  EXPECT_TRUE(Has(pfm.output, "g: min -1, mean 0.5, max 1\n")) << pfm.output;
  EXPECT_TRUE(Has(pfm.output, "mean luminance: 0.545\n")) << pfm.output;
  EXPECT_TRUE(Has(pfm.output, "values not finite: 2\nvalues negative: 1\n")) << pfm.output;

  const std::string png = Save(folder / "b.png", Filled(3, 1, {1, 1, 1}), {{"seed", "7"}});
  EXPECT_TRUE(Has(Rayimg({"info", png}).output, "seed: 7\n"));
}

TEST(RayimgInfo, OneBadFileDoesNotHideTheOthers) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.ppm", Filled(1, 1, {})), b = Save(folder / "b.ppm", Filled(2, 1, {}));
  const Finished done = Rayimg({"info", a, folder / "missing.ppm", b});
  EXPECT_EQ(done.status, 3);
  EXPECT_TRUE(Has(done.output, "a.ppm: ppm, 1x1") && Has(done.output, "b.ppm: ppm, 2x1")) << done.output;
  EXPECT_TRUE(Has(done.error, "missing.ppm")) << done.error;
}

TEST(RayimgInfo, APictureWithoutOneFiniteValueSaysSo) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const Finished done = Rayimg({"info", Save(folder / "a.pfm", Filled(2, 2, {nan, nan, nan}))});
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(Has(done.output, "r: no finite value\n")) << done.output;
}

// --- convert ---

TEST(RayimgConvert, AppliesExposureThenTheCurve) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string in = Save(folder / "in.pfm", Filled(2, 2, {0.25, 1, 3})), out = folder / "out.pfm";
  const auto converted = [&](const Words& options) {
    Words words{"convert", in, out};
    words.insert(words.end(), options.begin(), options.end());
    const Finished done = Rayimg(words);
    EXPECT_EQ(done.status, 0) << done.error;
    return Decode(out).image.At(1, 1);
  };
  EXPECT_EQ(converted({}), (R2::Color{0.25, 1, 3}));
  EXPECT_EQ(converted({"-exposure", "2"}), (R2::Color{1, 4, 12}));
  EXPECT_EQ(converted({"-exposure", "-1"}), (R2::Color{0.125, 0.5, 1.5}));
  EXPECT_EQ(converted({"-exposure=2", "--tonemap", "reinhard"}).r, 0.5);
  EXPECT_NEAR(converted({"-tonemap", "aces"}).g, 2.54 / 3.16, 1e-7);
  EXPECT_LE(converted({"-tonemap", "filmic"}).b, 1);
  EXPECT_EQ(converted({"-srgb"}), (R2::Color{0.25, 1, 3})) << "floats are never encoded";
}

// 0.5 is byte 128 when it is written straight, 188 with the sRGB curve, and 16 bits keep 257 times more.
TEST(RayimgConvert, EncodesAsAsked) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string in = Save(folder / "in.pfm", Filled(2, 2, {0.5, 0.5, 0.5})), out = folder / "out.png";
  Rayimg({"convert", in, out});
  EXPECT_NEAR(Decode(out).image.At(0, 0).r, 128 / 255.0, 1e-6);
  Rayimg({"convert", in, out, "-srgb"});
  EXPECT_NEAR(Decode(out).image.At(0, 0).r, 188 / 255.0, 1e-6);
  Rayimg({"convert", in, out, "-srgb", "-bits", "16"});
  EXPECT_NEAR(Decode(out).image.At(0, 0).r, R2::EncodeSrgb(0.5), 1 / 65535.0);
  Rayimg({"convert", out, folder / "back.pfm", "-srgb"});
  EXPECT_NEAR(Decode(folder / "back.pfm").image.At(0, 0).r, 0.5, 2 / 65535.0);
  const std::string best = folder / "best.jpg", worst = folder / "worst.jpg";
  Rayimg({"convert", in, best, "-jpeg_quality", "100"});
  Rayimg({"convert", in, worst, "-jpeg_quality", "1"});
  EXPECT_NE(ReadFile(best), ReadFile(worst));
}

TEST(RayimgConvert, KeepsSettingsAndAddsWhatWasDone) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string in = Save(folder / "in.png", Filled(2, 2, {0.5, 0.5, 0.5}), {{"seed", "7"}});
  Rayimg({"convert", in, folder / "once.jpg", "-exposure", "1"});
  Rayimg({"convert", folder / "once.jpg", folder / "twice.png", "-tonemap", "aces"});
  auto settings = Decode(folder / "twice.png").settings;
  EXPECT_EQ(settings["seed"], "7");
  EXPECT_TRUE(Has(settings["converted"], "-exposure 1; rayimg convert ")) << settings["converted"];
  EXPECT_TRUE(settings["converted"].ends_with("-tonemap aces")) << settings["converted"];
}

// --- merge ---

TEST(RayimgMerge, WeighsBySamplesAndAddsThemUp) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "no EXR in this build";
  const TemporaryFolder folder;
  const auto settings = [](const char* seed, const char* samples) {
    return R2::ImageSettings{{"seed", seed}, {"samples", samples}, {"scene_hash", "ab"}, {"seconds", "1"}};
  };
  const std::string a = Save(folder / "a.exr", Filled(3, 2, {0, 1, 2}), settings("1", "1"));
  const std::string b = Save(folder / "b.exr", Filled(3, 2, {4, 1, 0}), settings("2", "3"));
  const std::string out = folder / "out.exr";
  const Finished done = Rayimg({"merge", a, b, "-out", out});
  ASSERT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.error, "");
  auto merged = Decode(out);
  EXPECT_EQ(merged.image.At(2, 1), (R2::Color{3, 1, 0.5}));
  EXPECT_EQ(merged.settings["samples"], "4");
  EXPECT_EQ(merged.settings["seed"], "1 2");
  EXPECT_EQ(merged.settings["scene_hash"], "ab");
  EXPECT_FALSE(merged.settings.contains("seconds"));

  ASSERT_EQ(Rayimg({"merge", a, b, "-out", out, "-weights", "3,1"}).status, 0);
  merged = Decode(out);
  EXPECT_EQ(merged.image.At(0, 0), (R2::Color{1, 1, 1.5}));
  EXPECT_FALSE(merged.settings.contains("samples")) << "with weights of one's own, a sum means nothing";
}

TEST(RayimgMerge, PicturesWithoutSettingsWeighTheSame) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  Words words{"merge", "-out", folder / "mean.pfm"};
  for (int i = 1; i <= 10; ++i)
    words.push_back(Save(folder / (std::to_string(i) + ".pfm"), Filled(4, 4, {i * 0.1, i * 1e6, 7})));
  const Finished done = Rayimg(words);
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(Has(done.error, "does not tell its seed")) << done.error;
  const R2::Color mean = Decode(folder / "mean.pfm").image.At(3, 3);
  EXPECT_NEAR(mean.r, 0.55, 1e-7);
  EXPECT_EQ(mean.g, 5.5e6);
  EXPECT_EQ(mean.b, 7);
}

// The mean of a picture with itself has the noise of one, and would claim the samples of two.
TEST(RayimgMerge, RefusesWhatIsNotIndependentOrNotFinishedUnlessForced) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "no EXR in this build";
  const TemporaryFolder folder;
  const R2::Image image = Filled(2, 2, {0.5, 0.5, 0.5});
  const auto saved = [&](const char* name, const R2::ImageSettings& settings) {
    return Save(folder / name, image, settings);
  };
  const std::string a = saved("a.exr", {{"seed", "1"}, {"scene_hash", "ab"}, {"command", "raypro s a.exr"}});
  const std::string same_scene = saved("b.exr", {{"seed", "1"}, {"scene_hash", "ab"}, {"command", "raypro s b.exr"}});
  const std::string same_command = saved("c.exr", {{"seed", "1"}, {"command", "raypro s a.exr"}});
  const std::string merged = saved("d.exr", {{"seed", "3 1 2"}, {"scene_hash", "ab"}});
  const std::string stopped = saved("e.exr", {{"seed", "9"}, {"scene_hash", "ab"}, {"pixels", "3 of 4 pixels done"}});
  const std::string other_scene = saved("f.exr", {{"seed", "1"}, {"scene_hash", "cd"}});
  const std::string other_seed = saved("g.exr", {{"seed", "11"}, {"scene_hash", "ab"}, {"pixels", "complete"}});
  for (const std::string& second : {a, same_scene, same_command, merged, stopped}) {
    const Finished refused = Rayimg({"merge", a, second, "-out", folder / "out.exr"});
    EXPECT_EQ(refused.status, 2) << second;
    EXPECT_TRUE(Has(refused.error, "-force")) << refused.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "out.exr"));
    EXPECT_EQ(Rayimg({"merge", a, second, "-out", folder / "out.exr", "-force"}).status, 0) << second;
    std::filesystem::remove(folder / "out.exr");
  }
  for (const std::string& second : {other_scene, other_seed})
    EXPECT_EQ(Rayimg({"merge", a, second, "-out", folder / "out.exr"}).status, 0) << second;
}

// --- movie ---

/// A little reader of RIFF, by the specification and without a look at the writer.
struct Riff {
  std::string bytes;

  std::string Letters(std::size_t at) const { return bytes.substr(at, 4); }
  std::size_t Number(std::size_t at, std::size_t count = 4) const {
    std::size_t number = 0;
    for (std::size_t i = count; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return number;
  }

  /// Where the content of the chunk begins that the path leads to, "hdrl/strl/strh"; nothing if there is none, or if
  /// chunks do not fill what holds them to the byte.
  std::optional<std::size_t> Find(const std::string& path) const { return Find(path, 12, 8 + Number(4)); }
  std::optional<std::size_t> Find(const std::string& path, std::size_t at, std::size_t end) const {
    std::optional<std::size_t> found;
    const std::string name = path.substr(0, 4);
    while (at < end) {
      const bool is_list = Letters(at) == "LIST";
      const std::size_t size = Number(at + 4), content = at + 8;
      if (!found && (is_list ? Letters(content) : Letters(at)) == name) {
        found = path.size() > 4 ? Find(path.substr(5), content + 4, content + size) : content;
        if (!found) return {};
      }
      at = content + size + size % 2;
    }
    return at == end ? found : std::nullopt;
  }
};

/// Frames that differ, at least one of them of an odd number of bytes.
Words SaveFrames(const TemporaryFolder& folder, int count) {
  Words names;
  bool is_any_odd = false;
  for (int i = 0; i < count || !is_any_odd; ++i) {
    R2::Image image = Filled(24, 16, {0.1 * (i % 10), 0.5, 0.2});
    for (int k = 0; k <= i % 16; ++k) image.Set(k, k, {1, 0.05 * k, 0});
    names.push_back(Save(folder / ("frame" + std::to_string(i) + ".jpg"), image, {{"frame", std::to_string(i)}}));
    is_any_odd = is_any_odd || ReadFile(names.back()).size() % 2 == 1;
  }
  return names;
}

TEST(RayimgMovie, TheHeadersTellSizeSpeedAndNumberOfFrames) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const Words frames = SaveFrames(folder, 3);
  std::size_t largest = 0;
  for (const std::string& frame : frames) largest = std::max(largest, ReadFile(frame).size());
  Words words{"movie", folder / "out.avi", "-fps", "12.5"};
  words.insert(words.end(), frames.begin(), frames.end());
  const Finished done = Rayimg(words);
  ASSERT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.output + done.error, "");

  const Riff avi{ReadFile(folder / "out.avi")};
  EXPECT_EQ(avi.Letters(0) + avi.Letters(8), "RIFFAVI ");
  EXPECT_EQ(avi.Number(4), avi.bytes.size() - 8);
  const auto movie = avi.Find("hdrl/avih"), stream = avi.Find("hdrl/strl/strh"), format = avi.Find("hdrl/strl/strf");
  ASSERT_TRUE(movie && stream && format);
  EXPECT_EQ(avi.Number(*movie - 4), 56u);
  EXPECT_EQ(avi.Number(*movie), 80000u) << "microseconds a frame";
  EXPECT_EQ(avi.Number(*movie + 12), 0x10u) << "that there is an index";
  EXPECT_EQ(avi.Number(*movie + 16), frames.size());
  EXPECT_EQ(avi.Number(*movie + 24), 1u) << "streams";
  EXPECT_GE(avi.Number(*movie + 28), largest) << "players set this much aside";
  EXPECT_EQ(avi.Number(*movie + 32), 24u);
  EXPECT_EQ(avi.Number(*movie + 36), 16u);
  EXPECT_EQ(avi.Number(*stream - 4), 56u);
  EXPECT_EQ(avi.Letters(*stream) + avi.Letters(*stream + 4), "vidsMJPG");
  EXPECT_EQ(static_cast<double>(avi.Number(*stream + 24)) / static_cast<double>(avi.Number(*stream + 20)), 12.5);
  EXPECT_EQ(avi.Number(*stream + 32), frames.size());
  EXPECT_GE(avi.Number(*stream + 36), largest);
  EXPECT_EQ(avi.Number(*stream + 52, 2), 24u);
  EXPECT_EQ(avi.Number(*stream + 54, 2), 16u);
  EXPECT_EQ(avi.Number(*format - 4), 40u);
  EXPECT_EQ(avi.Number(*format), 40u);
  EXPECT_EQ(avi.Number(*format + 4), 24u);
  EXPECT_EQ(avi.Number(*format + 8), 16u);
  EXPECT_EQ(avi.Letters(*format + 16), "MJPG");
}

// Seen twice: by walking from chunk to chunk, as one plays, and through the index, as one jumps.
TEST(RayimgMovie, EveryFrameIsTheBytesOfItsJpegInChunksAndIndex) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  Words frames = SaveFrames(folder, 5);
  frames.push_back(frames.front());
  Words words{"movie", folder / "out.avi"};
  words.insert(words.end(), frames.begin(), frames.end());
  ASSERT_EQ(Rayimg(words).status, 0);

  const Riff avi{ReadFile(folder / "out.avi")};
  const auto movie = avi.Find("movi"), index = avi.Find("idx1");
  ASSERT_TRUE(movie && index);
  EXPECT_EQ(avi.Number(*avi.Find("hdrl/strl/strh") + 24), 25 * avi.Number(*avi.Find("hdrl/strl/strh") + 20));
  EXPECT_EQ(avi.Number(*index - 4), 16 * frames.size());
  std::size_t at = *movie + 4;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string jpeg = ReadFile(frames[i]);
    EXPECT_EQ(avi.Letters(at), "00dc") << i;
    ASSERT_EQ(avi.Number(at + 4), jpeg.size()) << i;
    EXPECT_EQ(avi.bytes.substr(at + 8, jpeg.size()), jpeg) << i;
    const std::size_t line = *index + 16 * i;
    EXPECT_EQ(avi.Letters(line), "00dc") << i;
    EXPECT_EQ(avi.Number(line + 4), 0x10u) << "a frame that needs no other, " << i;
    EXPECT_EQ(*movie + avi.Number(line + 8), at) << i;
    EXPECT_EQ(avi.Number(line + 12), jpeg.size()) << i;
    at += 8 + jpeg.size() + jpeg.size() % 2;
  }
  EXPECT_EQ(at, *movie + avi.Number(*movie - 4)) << "the list holds the frames and nothing else";
}

TEST(RayimgMovie, AnOlderMovieStaysWhenAFrameIsBad) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string good = Save(folder / "good.jpg", Filled(8, 8, {0.5, 0.5, 0.5}));
  const std::string cut = WriteFile(folder / "cut.jpg", ReadFile(good).substr(0, ReadFile(good).size() / 2));
  const std::string out = WriteFile(folder / "out.avi", "an older movie");
  EXPECT_EQ(Rayimg({"movie", out, good, cut}).status, 3);
  EXPECT_EQ(ReadFile(out), "an older movie");
  EXPECT_EQ(Rayimg({"movie", out, good}).status, 0);
  EXPECT_TRUE(ReadFile(out).starts_with("RIFF"));
}

// --- wrong input ---

TEST(Rayimg, WrongInputIsNamedInOneLineAndNothingIsWritten) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.png", Filled(4, 4, {0.5, 0.5, 0.5}));
  const std::string small = Save(folder / "small.png", Filled(2, 4, {}));
  const std::string light = Save(folder / "light.pfm", Filled(4, 4, {}));
  const std::string text = WriteFile(folder / "text.png", "this is no picture\n");
  const std::string empty = WriteFile(folder / "empty.exr", "");
  const std::string cut = WriteFile(folder / "cut.pfm", ReadFile(light).substr(0, 60));
  const std::string huge = WriteFile(folder / "huge.pfm", "PF\n1000000 1000000\n-1\n");
  const std::string frame = Save(folder / "frame.jpg", Filled(4, 4, {0.5, 0.5, 0.5}));
  const std::string wide = Save(folder / "wide.jpg", Filled(6, 4, {0.5, 0.5, 0.5}));
  const std::string avi = folder / "out.avi";
  const std::string out = folder / "out.png", missing = folder / "missing.png";
  const struct {
    Words words;
    int status;
    const char* message;
  } cases[] = {
      {{}, 2, "no command is named; it must be diff, info, convert, merge or movie"},
      {{"dif", a, a}, 2, "unknown command 'dif'; did you mean 'diff'?"},
      {{"frobnicate"}, 2, "it must be diff, info, convert, merge or movie"},
      {{"-versoin"}, 2, "did you mean '-version'?"},
      {{"-version", a}, 2, "unknown command"},
      {{"-complete"}, 2, "-complete needs a value: -complete shell"},
      {{"-complete", "csh"}, 2, "bash, zsh or fish"},
      {{"-help", "nothing"}, 2, "-help must be diff, info, convert, merge, movie, about or markdown"},
      {{"diff"}, 2, "needs 2 file names, got 0 (usage: rayimg diff picture reference [options])"},
      {{"diff", a, a, a}, 2, "unexpected extra argument"},
      {{"diff", a, ""}, 2, "a file name is empty"},
      {{"diff", a, a, "-fial", "1"}, 2, "unknown option '-fial'; did you mean '-fail'?"},
      {{"diff", a, a, "-exposure", "1"}, 2, "-exposure is an option of rayimg convert, not of diff"},
      {{"diff", a, a, "-fail"}, 2, "-fail needs a value: -fail x"},
      {{"diff", a, a, "-fail", "-1"}, 2, "-fail must be a number, at least 0, got '-1'"},
      {{"diff", a, a, "-fail", "nan"}, 2, "got 'nan'"},
      {{"diff", a, a, "-fail_percent", "1"}, 2, "-fail_percent has no effect without -fail"},
      {{"diff", a, a, "-fail", "0", "-fail_percent", "101"}, 2, "0 to 100"},
      {{"diff", a, a, "-json=yes"}, 2, "'-json' takes no value"},
      {{"diff", a, a, "-map_of", "flop", "-map", out}, 2, "flip or display, got 'flop'; did you mean 'flip'?"},
      {{"diff", a, a, "-map", folder / "out.xyz"}, 2, ".png"},
      {{"diff", a, small}, 2, "pictures must have one size"},
      {{"diff", a, missing, "-map", out}, 3, "missing.png"},
      {{"diff", a, text}, 3, "text.png: error: unknown image format"},
      {{"diff", a, empty}, 3, "empty.exr: error: the image file is empty"},
      {{"diff", light, cut}, 3, "cut.pfm"},
      {{"diff", light, huge}, 3, "more than the limit"},
      {{"diff", a, folder.Path().string()}, 3, "error"},
      {{"diff", a, a, "-reference2", missing}, 3, "missing.png"},
      {{"diff", a, a, "-map", a}, 4, "it is the input"},
      {{"diff", a, a, "-map", folder / "none/out.png"}, 4, "does not exist"},
      {{"info"}, 2, "needs 1 file name"},
      {{"info", text}, 3, "text.png"},
      {{"convert", a}, 2, "needs 2 file names, got 1"},
      {{"convert", a, folder / "out"}, 2, "extension"},
      {{"convert", a, out, "-tonemap", "ases"}, 2, "did you mean 'aces'?"},
      {{"convert", a, out, "-exposure", "12abc"}, 2, "-exposure must be a number, -64 to 64, got '12abc'"},
      {{"convert", a, out, "-bits", "12"}, 2, "-bits must be 8 or 16 bits per channel, got '12'"},
      {{"convert", a, folder / "out.jpg", "-bits", "16"}, 2, "-bits 16 needs a PNG"},
      {{"convert", a, out, "-jpeg_quality", "0"}, 2, "a whole number, 1 to 100"},
      {{"convert", text, out}, 3, "text.png"},
      {{"convert", a, a}, 4, "it is the input"},
      {{"merge", light, cut}, 2, "needs -out"},
      {{"merge", light, "-out", out}, 2, "needs 2 file names"},
      {{"merge", light, a, "-out", out}, 2, "rounded and clamped; merge takes pfm, hdr and exr"},
      {{"merge", light, light, "-out", out}, 2, "are the same file"},
      {{"merge", light, cut, "-out", out}, 3, "cut.pfm"},
      {{"merge", light, light, "-out", out, "-weights", "1,,2"}, 2, "numbers above 0, separated by commas"},
      {{"merge", light, light, "-out", out, "-weights", "1,0"}, 2, "numbers above 0, separated by commas"},
      {{"merge", light, light, "-out", out, "-weights", "1"}, 2, "-weights has 1 number for 2 pictures"},
      {{"merge", light, light, "-out", light}, 4, "it is the input"},
      {{"movie"}, 2, "needs 2 file names, got 0 (usage: rayimg movie out.avi frame.jpg... [options])"},
      {{"movie", avi}, 2, "needs 2 file names, got 1"},
      {{"movie", folder / "out.mp4", frame}, 2, "a movie's name ends in .avi, not"},
      {{"movie", frame, frame}, 2, "ends in .avi"},
      {{"movie", avi, frame, a}, 2, "is a png; the frames of a movie are jpeg"},
      {{"movie", avi, frame, wide}, 2, "pictures must have one size"},
      {{"movie", avi, frame, text}, 3, "text.png: error: unknown image format"},
      {{"movie", avi, frame, missing}, 3, "missing.png"},
      {{"movie", avi, frame, "-fps", "0"}, 2, "-fps must be a number, 0.1 to 1000, got '0'"},
      {{"movie", avi, frame, "-fps", "nan"}, 2, "got 'nan'"},
      {{"movie", folder / "none/out.avi", frame}, 4, "does not exist"},
      {{"movie", folder.Path().string() + "/.avi/", frame}, 2, "ends in .avi"},
  };
  const Words known{"a.png",   "small.png", "light.pfm", "text.png", "empty.exr",
                    "cut.pfm", "huge.pfm",  "frame.jpg", "wide.jpg"};
  for (const auto& [words, status, message] : cases) {
    const Finished done = Rayimg(words);
    EXPECT_EQ(done.status, status) << message << "\n" << done.output << done.error;
    EXPECT_TRUE(Has(done.error, message)) << message << "\n" << done.error;
    EXPECT_EQ(done.output, "") << message;
    EXPECT_EQ(std::ranges::count(done.error, '\n'), 1) << done.error;
    EXPECT_EQ(folder.Others(known), nothing) << message;
  }
}

// --- what it says of itself ---

TEST(Rayimg, HelpIsAnsweredAnywhere) {
  NEEDS_RAYIMG();
  for (const CommandKind& command : Commands()) {
    const Finished done = Rayimg({command.name, "no.png", "-nonsense", "-help"});
    EXPECT_EQ(done.status, 0);
    EXPECT_EQ(done.output, Help(program, command.name));
    EXPECT_EQ(Rayimg({"-help", command.name}).output, Help(program, command.name));
  }
  EXPECT_EQ(Rayimg({"--help"}).output, Help(program, ""));
  EXPECT_EQ(Rayimg({"-version"}).output, Version(program));
  EXPECT_EQ(Rayimg({"-man"}).output, ManualPage(program));
  EXPECT_EQ(Rayimg({"-complete", "fish"}).output, CompletionScript(program, "fish"));
}

TEST(RayimgHelp, NamesEveryOptionWhereItBelongsAndFitsTheScreen) {
  for (const CommandKind& command : Commands()) {
    EXPECT_TRUE(Has(Help(program, ""), "\n  " + std::string(command.name) + " ")) << command.name;
    const std::string help = Help(program, command.name);
    for (const OptionKind& option : OptionTable(program))
      EXPECT_EQ(Has(help, "\n  " + Synopsis(option)), Takes(command, option)) << command.name << " " << option.name;
    std::istringstream lines(help + Help(program, ""));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
  }
}

TEST(RayimgHelp, EveryOptionBelongsToACommandThatExists) {
  for (const OptionKind& option : OptionTable(program)) {
    EXPECT_EQ(option.commands.empty(), !IsSetting(option)) << option.name;
    for (const char* command : option.commands)
      EXPECT_TRUE(FindCommand(program, command)) << option.name << " " << command;
  }
}

TEST(RayimgHelp, EveryShellAndTheManualLearnEveryOption) {
  for (const OptionKind& option : OptionTable(program)) {
    const std::string name = option.name;
    EXPECT_TRUE(Has(CompletionScript(program, "bash"), "-" + name)) << name;
    EXPECT_TRUE(Has(CompletionScript(program, "zsh"), "'-" + name + "[")) << name;
    EXPECT_TRUE(Has(CompletionScript(program, "fish"), " -o " + name + " ")) << name;
    EXPECT_TRUE(Has(ManualPage(program), ".B \\-" + name)) << name;
  }
}

/// What bash offers for the last of the words.
std::string BashOffers(const std::string& words) {
  const TemporaryFolder folder;
  WriteFile(folder / "complete", CompletionScript(program, "bash"));
  const std::string command = "bash -c '. " + folder / "complete" + "; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rayimg; echo \"${COMPREPLY[@]}\"'";
  FILE* pipe = popen(command.c_str(), "r");
  char line[4096] = "";
  if (pipe && !std::fgets(line, sizeof line, pipe)) line[0] = 0;
  if (pipe) pclose(pipe);
  return line;
}

TEST(RayimgHelp, BashOffersCommandsTheirOptionsAndChoices) {
  if (std::system("command -v bash >/dev/null 2>&1") != 0) GTEST_SKIP() << "bash is not installed";
  EXPECT_EQ(BashOffers("rayimg con"), "convert\n");
  EXPECT_EQ(BashOffers("rayimg diff a.png -refer"), "-reference2\n");
  EXPECT_EQ(BashOffers("rayimg info -refer"), "\n");
  EXPECT_EQ(BashOffers("rayimg convert a b -tonemap f"), "filmic\n");
  EXPECT_EQ(BashOffers("rayimg -complete z"), "zsh\n");
}

// A reader of the documentation must not meet an option that is gone, or miss one.
TEST(RayimgHelp, TheDocumentedTableIsOurs) {
  const char* root = std::getenv("RAYPRO_ROOT");
  const std::string page = ReadFile(std::string(root ? root : ".") + "/docs/options.md");
  EXPECT_TRUE(Has(page, Help(program, "markdown"))) << "run script/update_docs.sh";
}

}  // namespace
}  // namespace ray::rayimg

// rayimg info, convert and merge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "R2/Color.h"
#include "tests/Project.h"
#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

TEST(RayimgInfo, PrintsStatisticsAndSettings) {
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

TEST(RayimgInfo, AFolderIsReportedAsOneAndAPipeIsRead) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const Finished refused = Rayimg({"info", folder.Path().string()});
  EXPECT_EQ(refused.status, 3);
  EXPECT_TRUE(Has(refused.error, "it is a folder")) << refused.error;
  const std::string file = Save(folder / "a.pfm", Filled(3, 2, {0, 1, 2})), said = folder / "said";
  const std::string command =
      "cat '" + file + "' | '" + testing::ProgramName("RAYIMG") + "' info /dev/stdin > '" + said + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(Has(ReadFile(said), "3x2")) << ReadFile(said);
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

TEST(RayimgInfo, AnImageWithoutOneFiniteValueIsReported) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const Finished done = Rayimg({"info", Save(folder / "a.pfm", Filled(2, 2, {nan, nan, nan}))});
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(Has(done.output, "r: no finite value\n")) << done.output;
}

// Everything unusual about a file is reported, and each thing once.
TEST(RayimgInfo, AnythingUnusualAboutAFileIsPrintedOnce) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string plain = Save(folder / "a.pfm", Filled(2, 2, {0.5, 1, 0}));
  const std::string odd = WriteFile(folder / "b.pfm", ReadFile(plain) + "!");
  const std::string warning = odd + ": warning: PFM has 1 byte after its image, which is ignored\n";
  EXPECT_EQ(Rayimg({"info", plain, odd}).error, warning);
  // Images are read twice.
  const Finished merged = Rayimg({"merge", plain, odd, "-force", "-out", folder / "c.pfm"});
  EXPECT_EQ(merged.status, 0) << merged.error;
  EXPECT_NE(merged.error.find(warning), std::string::npos) << merged.error;
  EXPECT_EQ(merged.error.find(warning), merged.error.rfind(warning)) << merged.error;
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

// 0.5 is byte 128 without the sRGB curve, 188 with it, and 16 bits keep 257 times more.
TEST(RayimgConvert, EncodesAsRequested) {
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

TEST(RayimgConvert, KeepsSettingsAndAddsItsOwn) {
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

// An error target or a time limit may stop a render between passes, and its samples are then a mean over the pixels.
TEST(RayimgMerge, FractionalSampleCountsAreWeightsToo) {
  NEEDS_RAYIMG();
  NEEDS_THE_PROGRAM();
  if (!HasExr()) GTEST_SKIP() << "no EXR in this build";
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.exr", Filled(3, 2, {0, 1, 2}), {{"seed", "1"}, {"samples", "2.5"}});
  const std::string b = Save(folder / "b.exr", Filled(3, 2, {4, 1, 0}), {{"seed", "2"}, {"samples", "7.5"}});
  const Finished done = Rayimg({"merge", a, b, "-out", folder / "out.exr"});
  ASSERT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.error, "");
  auto merged = Decode(folder / "out.exr");
  EXPECT_EQ(merged.image.At(2, 1), (R2::Color{3, 1, 0.5}));
  EXPECT_EQ(merged.settings["samples"], "10");

  const std::string scene = (project::Root() / "scenes/area_light.scn").string();
  const Words render{scene, folder / "c.exr", "-width", "96",      "-height",        "64", "-shadow_samples",
                     "1",   "-error",         "2",      "-report", folder / "c.json"};
  ASSERT_EQ(testing::RunProgram(render).status, 0);
  const std::string report = ReadFile(folder / "c.json"), stored = Decode(folder / "c.exr").settings["samples"];
  EXPECT_NE(stored.find('.'), std::string::npos) << "a whole mean tries nothing";
  EXPECT_TRUE(Has(report, "\"mean\": " + stored)) << stored << "\n" << report;
}

TEST(RayimgMerge, WeighsAllAlikeIfOneLacksItsSampleCount) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "no EXR in this build";
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.exr", Filled(3, 2, {0, 1, 2}), {{"seed", "1"}, {"samples", "1"}});
  const std::string b = Save(folder / "b.exr", Filled(3, 2, {4, 1, 0}), {{"seed", "2"}});
  const Finished done = Rayimg({"merge", a, b, "-out", folder / "out.exr"});
  ASSERT_EQ(done.status, 0) << done.error;
  EXPECT_TRUE(Has(done.error, "b.exr' does not record its samples per pixel; all images get the same weight"))
      << done.error;
  EXPECT_EQ(Decode(folder / "out.exr").image.At(2, 1), (R2::Color{2, 1, 1}));
}

TEST(RayimgMerge, ImagesWithoutSettingsWeighTheSame) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  Words words{"merge", "-out", folder / "mean.pfm"};
  for (int i = 1; i <= 10; ++i)
    words.push_back(Save(folder / (std::to_string(i) + ".pfm"), Filled(4, 4, {i * 0.1, i * 1e6, 7})));
  const Finished done = Rayimg(words);
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(Has(done.error, "records no seed; assuming it is independent")) << done.error;
  const R2::Color mean = Decode(folder / "mean.pfm").image.At(3, 3);
  EXPECT_NEAR(mean.r, 0.55, 1e-7);
  EXPECT_EQ(mean.g, 5.5e6);
  EXPECT_EQ(mean.b, 7);
}

// The mean of an image with itself has the noise of one, but its settings would state the samples of two.
TEST(RayimgMerge, RefusesDependentOrUnfinishedImagesUnlessForced) {
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
  for (const std::string& second : {a, same_scene, same_command, merged, stopped, other_scene}) {
    const Finished refused = Rayimg({"merge", a, second, "-out", folder / "out.exr"});
    EXPECT_EQ(refused.status, 2) << second;
    EXPECT_TRUE(Has(refused.error, "-force")) << refused.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "out.exr"));
    EXPECT_EQ(Rayimg({"merge", a, second, "-out", folder / "out.exr", "-force"}).status, 0) << second;
    std::filesystem::remove(folder / "out.exr");
  }
  EXPECT_EQ(Rayimg({"merge", a, other_seed, "-out", folder / "out.exr"}).status, 0);
}

// The mean of two scenes, or of a deep and a shallow render, is an image of neither.
TEST(RayimgMerge, RefusesImagesOfOtherSettingsUnlessForced) {
  NEEDS_RAYIMG();
  if (!HasExr()) GTEST_SKIP() << "no EXR in this build";
  const TemporaryFolder folder;
  int seed = 0;
  const auto saved = [&](const std::string& options, const std::string& camera = {}) {
    const std::string number = std::to_string(++seed), name = number + ".exr";
    R2::ImageSettings settings{{"seed", number},
                               {"scene_hash", "ab"},
                               {"command", "raypro s.scn " + name + " -seed " + number + " " + options}};
    if (!camera.empty()) settings["camera"] = camera;
    return Save(folder / name, Filled(2, 2, {0.5, 0.5, 0.5}), settings);
  };
  const std::string first = saved("-samples 4 -mode path"), out = folder / "out.exr";
  for (const std::string& other :
       {saved("-mode whitted"), saved(""), saved("-mode path -max_depth 9"), saved("-mode path", "camera 1")}) {
    const Finished refused = Rayimg({"merge", first, other, "-out", out});
    EXPECT_EQ(refused.status, 2) << other;
    EXPECT_TRUE(Has(refused.error, "different") && Has(refused.error, "-force")) << refused.error;
    EXPECT_EQ(Rayimg({"merge", first, other, "-out", out, "-force"}).status, 0);
  }
  for (const std::string& like : {saved("-mode path"), saved("-samples 64 -mode path -accel grid -quiet")}) {
    const Finished done = Rayimg({"merge", first, like, "-out", out});
    EXPECT_EQ(done.status, 0) << done.error;
  }
}

TEST(RayimgMerge, WeightsOfAnySizeGiveTheMean) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.pfm", Filled(2, 2, {0, 1, 1e30})),
                    b = Save(folder / "b.pfm", Filled(2, 2, {2, 1, 3e30})), out = folder / "out.pfm";
  for (const char* weights : {"1,1", "1e308,1e308", "1e-300,1e-300", "3,3"}) {
    ASSERT_EQ(Rayimg({"merge", a, b, "-out", out, "-force", "-weights", weights}).status, 0);
    EXPECT_EQ(Decode(out).image.At(1, 1).r, 1) << weights;
    EXPECT_EQ(Decode(out).image.At(1, 1).b, static_cast<double>(2e30f)) << weights;
  }
}

// --- movie ---

}  // namespace
}  // namespace ray::rayimg

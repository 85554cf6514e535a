// rayimg merge; tests/app/images.txt has more of it, and rayimg info and convert.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/Project.h"
#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

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
                     "1",   "-error",         "1",      "-report", folder / "c.json"};
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

}  // namespace
}  // namespace ray::rayimg

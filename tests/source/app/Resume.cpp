// Runs of raypro -resume, and the checkpoints that it accepts.
#include <gtest/gtest.h>
#include <signal.h>

#include <thread>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

const std::string soft_shadow =
    "area_light 1 1 1  0 3 0  0 -1 0  0.8  1 0 0\nsphere -1  0 0 0  0.5\nbox -1  -2 -0.6 -2  2 -0.5 2\n";

/// Renders 24x16 pixels with additional options.
Finished RenderWith(const std::string& scene, const std::string& image, std::vector<std::string> words) {
  words.insert(words.begin(), {scene, image, "-width", "24", "-height", "16"});
  return RunProgram(words);
}

TEST(Resume, WithoutACheckpointBeginsAndReportsIt) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", soft_shadow);
  const Finished done = RenderWith(scene, place / "out.png", {"-resume"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_TRUE(Has(done.error, "nothing to resume")) << done.error;
  EXPECT_EQ(place.Others({"in.scn", "out.png"}), std::vector<std::string>{});
}

TEST(Resume, AddsSamplesAsIfRequestedAtOnce) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", soft_shadow);
  for (const std::string filter : {"box", "gaussian"})
    for (const std::string mode : {"whitted", "path"})
      for (const std::string samples : {"5", "70"}) {
        const std::vector<std::string> both{"-filter", filter, "-mode", mode};
        const auto with = [&](std::vector<std::string> words) {
          words.insert(words.end(), both.begin(), both.end());
          return words;
        };
        ASSERT_EQ(RenderWith(scene, place / "a.pfm", with({"-samples", "4", "-keep_checkpoint"})).status, 0);
        ASSERT_EQ(place.Others({"in.scn", "a.pfm", "b.pfm"}), std::vector<std::string>{"a.pfm.checkpoint"});
        const Finished more = RenderWith(scene, place / "a.pfm", with({"-samples", samples, "-resume"}));
        ASSERT_EQ(more.status, 0) << more.error;
        ASSERT_EQ(RenderWith(scene, place / "b.pfm", with({"-samples", samples})).status, 0);
        EXPECT_TRUE(ReadFile(place / "a.pfm") == ReadFile(place / "b.pfm")) << filter << ' ' << mode << ' ' << samples;
        EXPECT_EQ(place.Others({"in.scn", "a.pfm", "b.pfm"}), std::vector<std::string>{});
      }
}

TEST(Resume, RefusesAnythingButTheImageOfOneRun) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", soft_shadow), image = place / "a.pfm";
  const struct {
    std::vector<std::string> first, then;
    const char* reason;
  } cases[] = {
      {{"-samples", "4"}, {"-samples", "2"}, "samples can be added but not removed"},
      {{"-samples", "4", "-sampler", "stratified"}, {"-samples", "8", "-sampler", "stratified"}, "in advance"},
      {{"-samples", "4", "-sampler", "grid"}, {"-samples", "9", "-sampler", "grid"}, "in advance"},
      {{"-samples", "6", "-filter", "mitchell"}, {"-samples", "8", "-filter", "mitchell"}, "1, 2, 4, ... 64, 128"},
      {{"-samples", "4", "-error", "100"}, {"-samples", "8", "-error", "100"}, "with -error"},
      {{"-samples", "4"}, {"-samples", "8", "-seed", "3"}, "-seed 0"},
      {{"-samples", "1"}, {"-samples", "4"}, "in the middle of its pixel"},
      {{"-time", "0.1"}, {}, "more than -samples 1: samples can be added but not removed"},
  };
  for (auto [first, then, reason] : cases) {
    first.insert(first.end(), {"-keep_checkpoint", "-restart"});
    then.emplace_back("-resume");
    ASSERT_EQ(RenderWith(scene, image, first).status, 0) << reason;
    const std::string before = ReadFile(image);
    const Finished done = RenderWith(scene, image, then);
    EXPECT_EQ(done.status, 3) << reason;
    EXPECT_TRUE(Has(done.error, reason)) << done.error;
    EXPECT_TRUE(ReadFile(image) == before);
  }
  // The hash means nothing to a user.
  WriteFile(scene, soft_shadow + std::string("sphere -1  0 9 0  .1\n"));
  const Finished other = RenderWith(scene, image, {"-samples", "4", "-resume"});
  EXPECT_EQ(other.status, 3);
  EXPECT_TRUE(Has(other.error, "cannot resume: the checkpoint belongs to a different scene\n")) << other.error;
}

/// A render of two seconds on any number of processors, and the files that it leaves when a signal ends it after half
/// of one.
class Interrupted : public ::testing::Test {
 protected:
  std::vector<std::string> Command(const std::string& image, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{place / "in.scn", place / image, "-width",   "64", "-height", "64",
                                   "-samples",       "3000",        "-threads", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Finished Interrupt(const std::string& image, const std::vector<std::string>& more = {}) const {
    Running running(Command(image, more));
    running.WaitUntilItCatches(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    running.Send(SIGINT);
    return running.Wait();
  }
  std::string Info(const std::string& image) const { return RunProgram({"-info", place / image}).output; }

  TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", "sphere -1  0 0 0  1\n");
};

using Names = std::vector<std::string>;

TEST_F(Interrupted, ARenderLeavesAFinishedImageAndWritesBesideIt) {
  NEEDS_THE_PROGRAM();
  for (const std::string extension : {"png", "pfm"}) {
    const std::string image = "out." + extension, partial = "out.partial." + extension;
    ASSERT_EQ(RenderWith(scene, place / image, {}).status, 0);
    const std::string before = ReadFile(place / image);
    const Finished done = Interrupt(image);
    EXPECT_EQ(done.status, 130) << done.error;
    EXPECT_TRUE(Has(done.error, "is unchanged; the image so far is '" + place / partial + "'")) << done.error;
    EXPECT_TRUE(Has(done.output, partial + " 64x64")) << done.output;
    EXPECT_TRUE(ReadFile(place / image) == before);
    EXPECT_EQ(place.Others({"in.scn", image, partial, partial + ".checkpoint"}), Names{});

    const Finished resumed = RunProgram(Command(image, {"-resume"}));
    EXPECT_EQ(resumed.status, 0) << resumed.error;
    EXPECT_EQ(place.Others({"in.scn", image}), Names{});
    const std::string after = ReadFile(place / image);
    ASSERT_EQ(RunProgram(Command(image)).status, 0);
    EXPECT_TRUE(ReadFile(place / image) == after) << "a resumed render gives the file of one that was not interrupted";
    std::filesystem::remove(place / image);
  }
}

TEST_F(Interrupted, ARenderReplacesTheImageOfAnInterruptedOne) {
  NEEDS_THE_PROGRAM();
  for (const Names& more : {Names{}, Names{"-resume"}, Names{"-restart"}}) {
    const Finished done = Interrupt("out.png", more);
    EXPECT_EQ(done.status, 130) << done.error;
    EXPECT_TRUE(Has(done.output, "out.png 64x64")) << done.output;
    EXPECT_EQ(place.Others({"in.scn", "out.png", "out.png.checkpoint"}), Names{});
    EXPECT_TRUE(Has(Info("out.png"), " samples per pixel done")) << Info("out.png");
  }
}

// Regression: a second command with the same output discarded hours of work.
TEST_F(Interrupted, ARenderTakesNoOtherRendersCheckpoint) {
  NEEDS_THE_PROGRAM();
  ASSERT_EQ(Interrupt("out.png").status, 130);
  const std::string checkpoint = ReadFile(place / "out.png.checkpoint"), image = ReadFile(place / "out.png");
  const Finished other = RenderWith(scene, place / "out.png", {});
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(Has(other.error, "out.png.checkpoint'; -resume continues from it, -restart")) << other.error;
  EXPECT_EQ(RenderWith(scene, place / "out.png", {"-resume"}).status, 3);  // it has another size
  EXPECT_EQ(RenderWith(scene, place / "out.png", {"-resume", "-restart"}).status, 2);
  EXPECT_TRUE(ReadFile(place / "out.png.checkpoint") == checkpoint && ReadFile(place / "out.png") == image);

  EXPECT_EQ(RenderWith(scene, place / "out.png", {"-restart"}).status, 0);
  EXPECT_TRUE(Has(Info("out.png"), "pixels: complete"));
  EXPECT_EQ(place.Others({"in.scn", "out.png"}), Names{});
}

TEST_F(Interrupted, ARenderCanResumeToFewerSamples) {
  NEEDS_THE_PROGRAM();
  ASSERT_EQ(Interrupt("out.pfm").status, 130);
  const Finished resumed = RunProgram(Command("out.pfm", {"-samples", "2500", "-resume"}));
  EXPECT_EQ(resumed.status, 0) << resumed.error;
  ASSERT_EQ(RunProgram(Command("whole.pfm", {"-samples", "2500"})).status, 0);
  EXPECT_TRUE(ReadFile(place / "out.pfm") == ReadFile(place / "whole.pfm"));
}

TEST_F(Interrupted, AddingSamplesLeavesTheFinishedImageAndItsCheckpoint) {
  NEEDS_THE_PROGRAM();
  ASSERT_EQ(RunProgram({scene, place / "out.pfm", "-width", "64", "-height", "64", "-samples", "4", "-keep_checkpoint"})
                .status,
            0);
  const std::string checkpoint = ReadFile(place / "out.pfm.checkpoint"), image = ReadFile(place / "out.pfm");
  ASSERT_EQ(Interrupt("out.pfm", {"-resume"}).status, 130);
  EXPECT_TRUE(ReadFile(place / "out.pfm.checkpoint") == checkpoint && ReadFile(place / "out.pfm") == image);
  EXPECT_EQ(RunProgram(Command("out.pfm", {"-resume", "-keep_checkpoint"})).status, 0);
  EXPECT_EQ(place.Others({"in.scn", "out.pfm", "out.pfm.checkpoint"}), Names{});
  EXPECT_NE(ReadFile(place / "out.pfm"), image);
}

}  // namespace
}  // namespace ray::testing

// Runs of raypro -resume after a signal; tests/app/budgets.txt has those after a render that ended.
#include <gtest/gtest.h>
#include <signal.h>

#include <thread>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

/// Renders 24x16 pixels with additional options.
Finished RenderWith(const std::string& scene, const std::string& image, std::vector<std::string> words) {
  words.insert(words.begin(), {scene, image, "-width", "24", "-height", "16"});
  return RunProgram(words);
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

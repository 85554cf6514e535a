#include "source/app/Interrupt.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <array>
#include <cstdlib>
#include <random>
#include <thread>
#include <utility>

#include "R2/ImageFile.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

TEST(Extremes, L5_ASignalEndsTheRunAndSavesTheImage) {
  NEEDS_THE_PROGRAM();
  std::mt19937 random(2);
  const int rounds = Rounds("RAYTESTS_SIGNALS", 4);
  constexpr std::array<std::pair<int, const char*>, 4> signals{
      {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}, {SIGXCPU, "SIGXCPU"}}};
  int early = 0;  // on a busy machine, before any pixel was rendered
  for (int round = 0; round < rounds; ++round) {
    const SceneFolder place;
    const auto [signal, name] = signals[static_cast<std::size_t>(round) % signals.size()];
    Running running({place.Scene(), place / "out.png", "-width", "3000", "-height", "3000", "-samples", "64"});
    running.WaitUntilItCatches(signal);
    std::this_thread::sleep_for(std::uniform_real_distribution(0.1, 0.5)(random) * 1s * project::patience);
    running.Send(signal);
    const auto sent = std::chrono::steady_clock::now();
    const Finished done = running.Wait();
    // Encoding nine million pixels takes time too, and the machine may be busy.
    EXPECT_LT(std::chrono::steady_clock::now() - sent, 10s * project::patience);
    EXPECT_EQ(done.status, 128 + signal) << done.error;
    if (Has(done.error, "stopped before the first pixel; there is no image to save")) {
      EXPECT_EQ(place.Others({"in.scn", "out.png.checkpoint"}), nothing);
      ++early;
      continue;
    }
    ASSERT_TRUE(fs::exists(place / "out.png")) << done.error;
    auto settings = Decode(place / "out.png").settings;
    EXPECT_TRUE(Has(settings["pixels"], " of 9000000 pixels done")) << settings["pixels"];
    EXPECT_GT(std::stod(settings["samples"]), 0);
    EXPECT_LT(std::stod(settings["samples"]), 64);
    EXPECT_TRUE(Has(done.output, std::string("stopped by ") + name)) << done.output;
    EXPECT_EQ(place.Others({"in.scn", "out.png", "out.png.checkpoint"}), nothing);
  }
  EXPECT_LT(early, rounds);
  std::printf("%d signals, %d of them before the first pixel\n", rounds, early);
}

TEST(Interrupt, LayersThatWereNotRenderedAreReported) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  Running running(
      {place.Scene(), place / "out.ppm", "-width", "3000", "-height", "3000", "-samples", "64", "-layers", "depth"});
  running.WaitUntilItCatches(SIGINT);
  std::this_thread::sleep_for(300ms);
  running.Send(SIGINT);
  const Finished done = running.Wait();
  EXPECT_TRUE(Has(done.error, "-layers are rendered once the image is complete; none are written")) << done.error;
  EXPECT_FALSE(fs::exists(place / "out.depth.ppm"));
}

// Regression: signals were handled between samples only. One sample here takes two billion rays.
TEST(Extremes, L5_ASignalEndsALoopOverManyLightSamples) {
  NEEDS_THE_PROGRAM();
  const std::string light = "area_light 1 1 1 0 3 0 0 -1 0 1 1 0 0 ", box = "box -1 -1 -1 -1 1 1 1\n";
  const std::string glowing = "material 0 0 0 .5 .5 .5 0 0 0 0 0 0 1 1 1 0 1 0\ntri 0 -1 3 -1 1 3 -1 0 3 1\n";
  const struct {
    std::string scene;
    std::vector<std::string> words;
  } runs[] = {{light + box, {"-shadow_samples", "2147483647"}},
              {light + box, {"-lights", "2147483647"}},
              {light + box, {"-lights", "2147483647", "-mode", "path"}},
              {"sphere_light 1 1 1 0 3 0 1 1 0 0 " + box, {"-shadow_samples", "2147483647", "-shadows", "off"}},
              {glowing + box, {"-shadow_samples", "2147483647"}}};
  for (const auto& [scene, words] : runs) {
    const SceneFolder place;
    WriteFile(place.Scene(), scene);
    Running running(With({place.Scene(), place / "out.ppm", "-width", "8", "-height", "8"}, words));
    running.WaitUntilItCatches(SIGINT);
    std::this_thread::sleep_for(400ms);
    EXPECT_FALSE(running.IsOver());
    running.Send(SIGINT);
    const Finished done = running.Wait(20s);  // otherwise minutes
    EXPECT_EQ(done.status, 130) << words[0] << done.error;
    EXPECT_TRUE(Has(done.error, "progress saved")) << done.error;
    EXPECT_EQ(place.Others({"in.scn", "out.ppm", "out.ppm.checkpoint"}), nothing);
  }
}

TEST(Extremes, L5_ASecondSignalQuitsAtOnceWithoutSaving) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  WriteFile(place / "out.ppm", "old");
  Running running({place.Scene(), place / "out.ppm", "-width", "3000", "-height", "3000", "-samples", "64"});
  running.WaitUntilItCatches(SIGTERM);  // the last handler to be installed
  std::this_thread::sleep_for(400ms);
  // Both signals are pending when the process continues, so it cannot end between them; the system chooses their order.
  for (const int signal : {SIGSTOP, SIGINT, SIGTERM, SIGCONT}) running.Send(signal);
  const int status = running.Wait().status;
  EXPECT_TRUE(status == 128 + SIGINT || status == 128 + SIGTERM) << status;
  EXPECT_EQ(ReadFile(place / "out.ppm"), "old");
  EXPECT_EQ(place.Others({"in.scn", "out.ppm"}), nothing);
}

// When a window is closed, its terminal and its shell each send SIGHUP, and the end of a session adds SIGTERM.
TEST(Interrupt, SignalsThatComeTogetherByThemselvesLoseNothing) {
  NEEDS_THE_PROGRAM();
  for (const auto& signals : {std::vector{SIGHUP, SIGTERM, SIGHUP}, std::vector{SIGXCPU, SIGXCPU, SIGXCPU}}) {
    const SceneFolder place;
    Running running({place.Scene(), place / "out.ppm", "-width", "100", "-height", "100", "-samples", "100000000"});
    running.WaitUntilItCatches(SIGTERM);
    std::this_thread::sleep_for(400ms * project::patience);
    running.Send(SIGSTOP);
    for (const int signal : signals) running.Send(signal);
    running.Send(SIGCONT);
    const Finished done = running.Wait();
    EXPECT_TRUE(Has(done.error, "progress saved")) << done.status << done.error;
    EXPECT_EQ(place.Others({"in.scn", "out.ppm", "out.ppm.checkpoint"}), nothing);
    EXPECT_TRUE(fs::exists(place / "out.ppm"));
  }
}

// "exec" keeps the process, so that the settings of the shell apply to the program.
Finished RunByShell(const SceneFolder& place, const std::string& before, const std::vector<std::string>& more) {
  std::vector<std::string> words{"-c", before + "exec \"$RAYPRO\" \"$@\"", "sh", place.Scene(), place / "out.ppm"};
  setenv("RAYTESTS_SHELL", "/bin/sh", 1);
  return RunProgram(With(words, more), {.program = "RAYTESTS_SHELL"});
}

// `ulimit -t` sets the hard limit too, where the system sends SIGKILL.
TEST(Interrupt, ALimitOfProcessorTimeSavesTheImage) {
  NEEDS_THE_PROGRAM();
  if (project::patience > 1) GTEST_SKIP() << "sanitizers take the seconds for themselves";
  for (const std::string limit : {"ulimit -t 3; ", "ulimit -St 1; "}) {
    const SceneFolder place;
    const Finished done =
        RunByShell(place, limit, {"-width", "64", "-height", "64", "-samples", "100000000", "-threads", "1"});
    EXPECT_EQ(done.status, 128 + SIGXCPU) << limit << done.signal << done.error;
    EXPECT_TRUE(fs::exists(place / "out.ppm")) << limit;
    EXPECT_TRUE(fs::exists(place / "out.ppm.checkpoint")) << limit;
  }
}

TEST(Interrupt, AnIgnoredHangupIsIgnored) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const Finished done = RunByShell(place, "trap '' HUP; (sleep 0.2; kill -HUP $$) & ",
                                   {"-width", "64", "-height", "64", "-time", "1", "-samples", "100000000"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_FALSE(Has(done.output, "SIGHUP")) << done.output;
}

}  // namespace
}  // namespace ray::testing

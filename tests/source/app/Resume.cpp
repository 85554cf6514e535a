// raypro -resume and what it goes on from, from outside.
#include <gtest/gtest.h>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

const std::string soft_shadow =
    "area_light 1 1 1  0 3 0  0 -1 0  0.8  1 0 0\nsphere -1  0 0 0  0.5\nbox -1  -2 -0.6 -2  2 -0.5 2\n";

/// A render of 24x16 pixels with these options besides.
Finished RenderWith(const std::string& scene, const std::string& picture, std::vector<std::string> words) {
  words.insert(words.begin(), {scene, picture, "-width", "24", "-height", "16"});
  return RunProgram(words);
}

TEST(Resume, WithoutACheckpointBeginsAndSaysSo) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", soft_shadow);
  const Finished done = RenderWith(scene, place / "out.png", {"-resume"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_TRUE(Has(done.error, "nothing to resume")) << done.error;
  EXPECT_EQ(place.Others({"in.scn", "out.png"}), std::vector<std::string>{});
}

TEST(Resume, AddsSamplesToAFinishedPictureAsIfTheyHadBeenAskedForAtOnce) {
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

TEST(Resume, RefusesWhatWouldNotBeThePictureOfOneRun) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", soft_shadow), picture = place / "a.pfm";
  const struct {
    std::vector<std::string> first, then;
    const char* reason;
  } cases[] = {
      {{"-samples", "4"}, {"-samples", "2"}, "samples can be added, not taken away"},
      {{"-samples", "4", "-sampler", "stratified"}, {"-samples", "8", "-sampler", "stratified"}, "beforehand"},
      {{"-samples", "4", "-sampler", "grid"}, {"-samples", "9", "-sampler", "grid"}, "beforehand"},
      {{"-samples", "6", "-filter", "mitchell"}, {"-samples", "8", "-filter", "mitchell"}, "1, 2, 4, ... 64, 128"},
      {{"-samples", "4", "-error", "100"}, {"-samples", "8", "-error", "100"}, "with -error"},
      {{"-samples", "4"}, {"-samples", "8", "-seed", "3"}, "-seed 0"},
  };
  for (auto [first, then, reason] : cases) {
    first.emplace_back("-keep_checkpoint");
    then.emplace_back("-resume");
    ASSERT_EQ(RenderWith(scene, picture, first).status, 0) << reason;
    const std::string before = ReadFile(picture);
    const Finished done = RenderWith(scene, picture, then);
    EXPECT_EQ(done.status, 3) << reason;
    EXPECT_TRUE(Has(done.error, reason)) << done.error;
    EXPECT_TRUE(ReadFile(picture) == before);
  }
}

}  // namespace
}  // namespace ray::testing

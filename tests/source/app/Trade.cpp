// The options that trade time for accuracy, on the command line and in runs.
#include <gtest/gtest.h>

#include <thread>

#include "R2/ImageFile.h"
#include "source/app/files/LayerImages.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/Preset.h"
#include "source/app/options/RenderChecks.h"
#include "tests/source/app/Place.h"

namespace ray {
namespace {

using testing::Finished;
using testing::Has;
using testing::List;
using testing::Place;
using testing::ReadFile;
using testing::Running;
using testing::RunProgram;
using testing::With;

RenderOptions Parsed(const List& more) { return ReadCommandLine(Program::raypro, With({"in.scn", "out.ppm"}, more)); }

std::string ErrorOf(const List& more) {
  return project::MessageOf<UsageError>([&] {
    RenderOptions options = Parsed(more);
    CompleteForScene(options);
  });
}

TEST(TradeWords, AFilterHasANameAndTheCoursesNumber) {
  for (std::size_t i = 0; i < filter_names.size(); ++i) {
    EXPECT_EQ(Parsed({"-filter", filter_names[i]}).render.filter, static_cast<FilterKind>(i));
    EXPECT_EQ(Parsed({"-filter", std::to_string(i)}).render.filter, static_cast<FilterKind>(i));
  }
}

TEST(TradeWords, LayersBesideADenoisedImageAreUnchanged) {
  const RenderSettings image = Parsed({"-denoise", "-samples", "4", "-layers", "albedo"}).render;
  EXPECT_TRUE(image.denoise);
  EXPECT_FALSE(SettingsForLayer(image, Layer::albedo).denoise);
}

TEST(TradeWords, DenoiseNeedsLightSamplesAndTimeThatItKnows) {
  EXPECT_EQ(ErrorOf({"-denoise", "-samples", "2"}), "");
  EXPECT_EQ(ErrorOf({"-denoise", "-error", "2"}), "");
  EXPECT_EQ(
      ErrorOf({"-denoise", "-samples", "16", "-mode", "path", "-bytes", "truncated", "-crop", "0", "0", "4", "4"}), "");
  for (const List& budget : {List{"-time", "1s"}, {"-samples", "4", "-time", "1s"}, {"-time", "1s", "-error", "2"}})
    EXPECT_EQ(ErrorOf(With({"-denoise"}, budget)), "");
}

TEST(TradeWords, NeighborsAndGridsTakeSomeCounts) {
  EXPECT_EQ(ErrorOf({"-adaptive", "neighbors", "-samples", "4"}), "");
  EXPECT_EQ(ErrorOf({"-sampler", "rotated_grid", "-samples", "12", "-shutter_samples", "3"}), "");
  EXPECT_EQ(ErrorOf({"-aperture", "0.1", "-focus", "3"}), "");
  EXPECT_EQ(Parsed({"-reference", "a.exr,b.exr"}).files.reference, (List{"a.exr", "b.exr"}));
}

TEST(TradeWords, AnErrorHasAUnitAfterItsNumber) {
  const struct {
    const char* word;
    double value;
    ErrorUnit unit;
  } good[] = {{"2", 2, ErrorUnit::display},         {"0.25", 0.25, ErrorUnit::display},
              {"3%", 3, ErrorUnit::relative},       {"40dB", 40, ErrorUnit::decibel},
              {"0.01lin", 0.01, ErrorUnit::linear}, {"1e-3lin", 1e-3, ErrorUnit::linear}};
  for (const auto& [word, value, unit] : good) {
    const auto error = Parsed({"-error", word}).render.budget.error;
    ASSERT_TRUE(error) << word;
    EXPECT_EQ(error->value, value) << word;
    EXPECT_EQ(error->unit, unit) << word;
    EXPECT_EQ(ReadErrorTarget(ShowErrorTarget(error)), std::optional(error)) << word;
  }
  for (const char* word : {"0", "-1", "0%", "-40dB", "abc", "%", "dB", "lin", "3%%", "3 %", "40 dB", "40db", "1e999",
                           "nan", "inf", "nandB", "0x2", "2,5", ""})
    EXPECT_TRUE(Has(ErrorOf({"-error", word}), "-error must be an error above 0")) << word;
}

TEST(TradeWords, ATimeHasAUnitOrIsInSeconds) {
  const struct {
    const char* word;
    double seconds;
  } good[] = {{"30s", 30}, {"5m", 300}, {"1h", 3600}, {"90", 90}, {"1.5h", 5400}, {"0.25s", 0.25}};
  for (const auto& [word, seconds] : good) {
    EXPECT_EQ(Parsed({"-time", word}).render.budget.seconds, seconds) << word;
    EXPECT_EQ(ReadDuration(ShowDuration(seconds)), seconds) << word;
  }
  for (const char* word : {"0", "0s", "-3", "-3s", "5d", "s", "h", "1h30m", "5 m", "5ms", "nan", "inf", "1e999", ""})
    EXPECT_TRUE(Has(ErrorOf({"-time", word}), "-time must be a duration")) << word;
}

TEST(TradeWords, OptionsOverridePresetsInAnyOrder) {
  ASSERT_GE(Presets().size(), 4u);
  const RenderOptions draft = Parsed({"-quality", "draft"});
  EXPECT_EQ(draft.render.samples, 4);
  EXPECT_EQ(draft.render.trace.max_depth, 20);
  EXPECT_EQ(draft.render.trace.roulette, Roulette::on);
  for (const List& words : {List{"-quality", "draft", "-samples", "9"}, {"-samples", "9", "-quality", "draft"}}) {
    EXPECT_EQ(Parsed(words).render.samples, 9);
    EXPECT_EQ(Parsed(words).render.trace.max_depth, 20);
  }
  EXPECT_EQ(Parsed({"-quality", "draft", "-maxreflections", "7"}).render.trace.max_depth, 7);  // by an alias too
  EXPECT_EQ(Parsed({"-quality", "preview"}).render.budget.error->value, 4);
  const auto error = Parsed({"-quality", "preview", "-error", "30dB"}).render.budget.error;
  EXPECT_EQ(error->value, 30);
  EXPECT_EQ(error->unit, ErrorUnit::decibel);
  // An option given its default counts as given.
  EXPECT_EQ(Parsed({"-quality", "final", "-max_depth", "3"}).render.trace.max_depth, 3);
  EXPECT_EQ(Parsed({"-quality", "final"}).render.trace.max_depth, 20);
  EXPECT_EQ(Parsed({"-quality", "custom"}).render.samples, 1);
}

// Runs of the program.

TEST(Replay, ThatASignalEndedIsResumed) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const List settings{"-mode", "path", "-width", "150", "-height", "100"};
  ASSERT_EQ(place.Run("a.pfm", With(settings, {"-samples", "256", "-report", place / "r.json"})).status, 0);
  const List replay = With(settings, {"-replay", place / "r.json"});
  const List command = With({place.Scene(), place / "b.pfm"}, replay);
  Running running(command);
  running.WaitUntilItCatches(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  running.Send(SIGINT);
  const Finished stopped = running.Wait();
  if (stopped.status == 0) GTEST_SKIP() << "it was faster than the signal";
  EXPECT_FALSE(Has(stopped.output, " of 1 samples")) << stopped.output;
  const Finished resumed = RunProgram(With(command, {"-resume"}));
  EXPECT_EQ(resumed.status, 0) << resumed.error;
  EXPECT_TRUE(ReadFile(place / "a.pfm") == ReadFile(place / "b.pfm"));
}

/// Renders a.pfm and its report r.json with a time limit and -denoise. On a busy machine, the first ray may come after
/// seconds, and the image is then correctly not denoised; so the limit is doubled until it is.
Finished RunDenoisedInTime(const Place& place, const List& words) {
  constexpr int most = 128;  // seconds
  Finished run;
  for (int seconds = 1; seconds <= most; seconds *= 2) {
    run = place.Run("a.pfm", With(words, {"-time", std::to_string(seconds) + "s", "-report", place / "r.json"}));
    if (run.status != 0 || Has(ReadFile(place / "r.json"), "denoised_by")) break;
  }
  return run;
}

TEST(Replay, RepeatsTimedDenoisedImagesToTheByte) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const List settings{"-denoise", "-shadow_samples", "1"};
  for (const List& more : {List{}, {"-error", "0.1"}}) {
    const Finished first = RunDenoisedInTime(place, With(settings, more));
    ASSERT_EQ(first.status, 0) << first.error;
    EXPECT_TRUE(Has(ReadFile(place / "r.json"), "\"denoised_by\": \"regression\"")) << first.error;
    const Finished again =
        place.Run("b.pfm", With(settings, {"-replay", place / "r.json", "-threads", "3", "-tile_size", "8"}));
    ASSERT_EQ(again.status, 0) << again.error;
    EXPECT_TRUE(ReadFile(place / "a.pfm") == ReadFile(place / "b.pfm"));
  }
}

}  // namespace
}  // namespace ray

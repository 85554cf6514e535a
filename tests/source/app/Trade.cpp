// The options that trade time for accuracy, on the command line and in runs.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <thread>

#include "R2/ImageFile.h"
#include "source/app/Status.h"
#include "source/app/files/LayerImages.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/Preset.h"
#include "source/app/options/RenderChecks.h"
#include "tests/Folder.h"
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
using testing::soft_scene;
using testing::TemporaryFolder;
using testing::With;
using testing::WriteFile;

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

TEST(Replay, RepeatsRendersEndedByErrorOrTimeToTheByte) {
  NEEDS_THE_PROGRAM();
  for (const List& budget : {List{"-error", "6"},
                             {"-error", "30dB", "-mode", "path", "-filter", "mitchell"},
                             {"-time", "0.3s"},
                             {"-time", "0.3s", "-error", "0.1"},
                             {"-time", "0.2s", "-sampler", "stratified", "-mode", "path"}}) {
    const Place place;
    const Finished first = place.Run("a.pfm", With({"-report", place / "r.json", "-shadow_samples", "1"}, budget));
    ASSERT_EQ(first.status, 0) << first.error;
    List same{"-replay", place / "r.json", "-shadow_samples", "1", "-threads", "3", "-tile_size", "8"};
    for (std::size_t i = 0; i < budget.size(); i += 2)
      if (budget[i] != "-error" && budget[i] != "-time") same.insert(same.end(), {budget[i], budget[i + 1]});
    const Finished again = place.Run("b.pfm", same);
    ASSERT_EQ(again.status, 0) << again.error;
    EXPECT_TRUE(ReadFile(place / "a.pfm") == ReadFile(place / "b.pfm")) << budget[0] << ' ' << budget[1];
    const std::string report = ReadFile(place / "r.json");
    EXPECT_TRUE(Has(report, "\"reason\": \"time\"") || Has(report, "\"reason\": \"error\"")) << report;
  }
}

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

TEST(Report, OfAResumedFinishedRenderHasEachPassOnce) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const List settings{"-mode", "path", "-samples", "16", "-denoise", "-keep_checkpoint"};
  const auto passes = [&](const char* more) {
    List words = With(settings, {"-report", place / "r.json"});
    if (*more) words.emplace_back(more);
    EXPECT_EQ(place.Run("a.pfm", words).status, 0);
    const std::string report = ReadFile(place / "r.json");
    std::string ends;
    for (std::size_t at = report.find("\"passes\""); (at = report.find("\"end\": ", at)) != std::string::npos; ++at)
      ends += report.substr(at + 7, 3);
    const std::size_t before = report.find("before_denoising");
    return ends + report.substr(before, report.find(',', before) - before);
  };
  const std::string first = passes("");
  EXPECT_TRUE(Has(first, "before_denoising")) << first;
  EXPECT_EQ(passes("-resume"), first);
}

TEST(Time, TooShortForTheImageWarnsAndStillMakesIt) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished run = place.Run("a.png", {"-time", "0.001s", "-width", "400", "-height", "300"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(Has(run.error, "-time 0.001s is too short: filling and writing 400x300 pixels alone takes about "))
      << run.error;
  EXPECT_TRUE(std::filesystem::exists(place / "a.png"));
}

TEST(Replay, MakesADenoisedImageAgainToTheByte) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const List settings{"-mode", "path", "-denoise"};
  ASSERT_EQ(place.Run("a.pfm", With(settings, {"-samples", "8", "-report", place / "r.json"})).status, 0);
  const std::string report = ReadFile(place / "r.json");
  EXPECT_TRUE(Has(report, "\"method\": \"two streams, denoised\"")) << report;
  EXPECT_TRUE(Has(report, "\"before_denoising\": ")) << report;
  ASSERT_EQ(place.Run("b.pfm", With(settings, {"-replay", place / "r.json"})).status, 0);
  EXPECT_TRUE(ReadFile(place / "a.pfm") == ReadFile(place / "b.pfm"));
  const Finished other = place.Run("b.pfm", {"-mode", "path", "-replay", place / "r.json"});
  EXPECT_TRUE(Has(other.error, "-denoise")) << other.error;
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

// If the replay denoised it, the image would differ.
TEST(Time, TooShortForDenoisingWarnsAndReplaysSkipItToo) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const List settings{"-denoise", "-width", "800", "-height", "600", "-threads", "1"};
  const Finished run = place.Run("a.pfm", With(settings, {"-time", "0.1s", "-report", place / "r.json"}));
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(Has(run.error, "-time 0.1s is too short for -denoise: filtering and writing 800x600 pixels alone takes"))
      << run.error;
  EXPECT_TRUE(Has(run.error, "warning: the image is not denoised: -time 0.1s left too little")) << run.error;
  EXPECT_FALSE(Has(ReadFile(place / "r.json"), "denoised_by"));
  ASSERT_EQ(place.Run("b.pfm", With(settings, {"-replay", place / "r.json"})).status, 0);
  EXPECT_TRUE(ReadFile(place / "a.pfm") == ReadFile(place / "b.pfm"));
}

// Regression: the JSON library formats a value by recursion, and a deeply nested report overflowed the stack while its
// error was being written.
TEST(Replay, RefusesADeeplyNestedReport) {
  NEEDS_THE_PROGRAM();
  const Place place;
  ASSERT_EQ(place.Run("a.ppm", {"-report", place / "r.json"}).status, 0);
  const std::string report = ReadFile(place / "r.json"), value = "\"seed\": 0";
  ASSERT_TRUE(Has(report, value));
  for (const std::size_t depth : {101u, 80'000u, 1'000'000u}) {
    const std::string nested = std::string(depth, '[') + std::string(depth, ']');
    std::string edited = report;
    edited.replace(edited.find(value), value.size(), "\"seed\": " + nested);
    for (const std::string& text : {edited, nested}) {
      WriteFile(place / "bad.json", text);
      const Finished done = place.Run("b.ppm", {"-replay", place / "bad.json"});
      EXPECT_EQ(done.status, 3) << depth;
      EXPECT_TRUE(Has(done.error, "nested deeper than 100 levels")) << done.error;
    }
  }
}

TEST(Replay, ShortensALongValueInItsMessage) {
  NEEDS_THE_PROGRAM();
  const Place place;
  ASSERT_EQ(place.Run("a.ppm", {"-report", place / "r.json"}).status, 0);
  std::string report = ReadFile(place / "r.json");
  const std::string value = "\"seed\": 0";
  ASSERT_TRUE(Has(report, value));
  report.replace(report.find(value), value.size(), "\"seed\": \"" + std::string(1'000'000, 'x') + "\"");
  WriteFile(place / "r.json", report);
  const Finished done = place.Run("b.ppm", {"-replay", place / "r.json"});
  EXPECT_EQ(done.status, 2);
  EXPECT_TRUE(Has(done.error, "was made with -seed")) << done.error.substr(0, 1000);
  EXPECT_LT(done.error.size(), 400u);
}

// K11 of the hard inputs. Regression: a run replaced its reference and its report by outputs of the same name.
TEST(InputsOfTheCommandLine, AreNeverOverwritten) {
  NEEDS_THE_PROGRAM();
  const Place place;
  ASSERT_EQ(place.Run("first.png", {"-report", place / "first.json"}).status, 0);
  std::filesystem::copy_file(place / "first.png", place / "picture.checkpoint");
  std::filesystem::copy_file(place / "first.json", place / "picture.png.checkpoint");
  std::filesystem::create_hard_link(place / "first.png", place / "same.png");
  const std::string image = ReadFile(place / "first.png"), report = ReadFile(place / "first.json");
  const std::string replay = place / "first.json", reference = place / "first.png";
  const struct {
    std::string image;
    List words;
  } runs[] = {{"first.png", {"-reference", reference}},
              {"same.png", {"-reference", reference}},
              {"out.png", {"-reference", reference, "-report", reference}},
              {"out.png", {"-reference", (place / "picture.checkpoint") + "," + reference, "-report", reference}},
              {"out.png", {"-replay", replay, "-report", replay}},
              {"picture.png", {"-replay", place / "picture.png.checkpoint"}}};
  for (const auto& [name, words] : runs) {
    const Finished done = place.Run(name, words);
    EXPECT_EQ(done.status, 4) << name << done.error;
    EXPECT_TRUE(Has(done.error, "it is the input")) << done.error;
    EXPECT_TRUE(ReadFile(place / "first.png") == image && ReadFile(place / "first.json") == report);
    EXPECT_TRUE(ReadFile(place / "picture.png.checkpoint") == report);
  }
}

TEST(Reference, ASecondOneIsAnotherFile) {
  NEEDS_THE_PROGRAM();
  const Place place;
  ASSERT_EQ(place.Run("a.pfm", {}).status, 0);
  const Finished same = place.Run("b.pfm", {"-reference", (place / "a.pfm") + "," + (place / "./a.pfm")});
  EXPECT_EQ(same.status, 2);
  EXPECT_TRUE(Has(same.error, "are the same file")) << same.error;
  ASSERT_EQ(place.Run("c.pfm", {"-seed", "1"}).status, 0);
  EXPECT_EQ(place.Run("b.pfm", {"-reference", (place / "a.pfm") + "," + (place / "c.pfm")}).status, 0);
}

std::string Pfm(int width, int height, float value) {
  std::string bytes = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
  for (int i = 0; i < 3 * width * height; ++i) {
    char float_bytes[sizeof value];
    std::memcpy(float_bytes, &value, sizeof value);
    bytes.append(float_bytes, sizeof value);
  }
  return bytes;
}

TEST(Environment, ThatCannotBeALightIsAFileError) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished good = place.Run("a.ppm", {"-env", WriteFile(place / "good.pfm", Pfm(8, 4, 0.5f))});
  EXPECT_EQ(good.status, 0) << good.error;
  std::string one_nan = Pfm(8, 4, 0.5f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(one_nan.data() + one_nan.size() - 4 * sizeof nan, &nan, sizeof nan);
  WriteFile(place / "text.pfm", "there is no light in words\n");
  WriteFile(place / "shape.pfm", Pfm(7, 3, 0.5f));
  WriteFile(place / "nan.pfm", one_nan);
  WriteFile(place / "negative.pfm", Pfm(8, 4, -0.5f));
  WriteFile(place / "infinite.pfm", Pfm(8, 4, HUGE_VALF));
  WriteFile(place / "short.pfm", Pfm(8, 4, 0.5f).substr(0, 60));
  for (const std::string name :
       {"missing.pfm", "text.pfm", "shape.pfm", "nan.pfm", "negative.pfm", "infinite.pfm", "short.pfm"}) {
    const Finished done = place.Run("b.ppm", {"-env", place / name});
    EXPECT_EQ(done.status, 3) << name << done.error;
    EXPECT_TRUE(Has(done.error, name)) << done.error;
    EXPECT_FALSE(Has(done.error, "terminate")) << done.error;
  }
  EXPECT_EQ(place.Run("b.ppm", {"-env", place.Path().string()}).status, 3);
}

}  // namespace
}  // namespace ray

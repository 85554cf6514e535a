#include "source/app/report/RunLog.h"

#include <algorithm>
#include <utility>

#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/files/SceneHash.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/FileNames.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/BlackImage.h"
#include "source/app/report/Check.h"
#include "source/app/report/Messages.h"
#include "source/integrate/lights/LightSource.h"
#include "source/render/SceneFeatures.h"
#include "source/render/Schedule.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Returns "-focus has no effect without -aperture" and so on: options that were typed but that this image, or this
/// acceleration structure, does not use.
std::vector<std::string> OptionsWithoutEffect(const RenderOptions& options) {
  std::vector<std::string> lines;
  for (const OptionKind& option : OptionTable(*options.program))
    if (const std::string why = options.WhyWithoutEffect(option); options.IsGiven(option.name) && !why.empty())
      lines.push_back("-" + std::string(option.name) + " has no effect " + why);
  const RenderSettings& render = options.render;
  if (options.IsGiven("samples") && render.samples > 1 && render.samples % 2 == 1 && HasTwoStreams(render))
    lines.push_back("-samples " + std::to_string(render.samples) +
                    ": the error estimate compares two halves of the samples, so " +
                    std::to_string(render.samples - 1) + " are taken");
  return lines;
}

/// Returns "8192x8192", the size of the crop if there is one.
std::string PixelsAcross(const RenderSettings& render) {
  const PixelRectangle part = render.crop.value_or(PixelRectangle{0, 0, render.width, render.height});
  return std::to_string(part.Width()) + "x" + std::to_string(part.Height());
}

/// Returns a line about the effects of -crop, and the extra pixels rendered for it.
std::string CropLine(const RenderSettings& render) {
  const std::vector<std::string> differences = CropDifferences(render);
  std::string line = "the crop: the same pixels, bit for bit, as in the whole image";
  if (!differences.empty()) {
    line = "the crop: not the pixels of the whole image, because of";
    for (const std::string& setting : differences) line += (setting == differences[0] ? " -" : ", -") + setting;
  }
  const int around = SurroundingsOf(render);
  return around > 0 ? line + "; " + std::to_string(around) + " pixels around it are rendered too" : line;
}

std::vector<std::string> ExplainRender(const World& world, const RunStats& stats) {
  const auto listed = [](const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list.empty() ? std::string("none") : list;
  };
  std::vector<std::string> lines{"features: " + listed(stats.needs), "kernel: " + stats.kernel,
                                 "sources of bias: " + listed(stats.biased)};
  std::string settings;
  for (const OptionKind& option : OptionTable(*stats.options.program))
    if (IsSetting(option) && !option.facts.Has(Fact::messages) && !stats.options.Show(option).empty())
      settings += " -" + std::string(option.name) + " " + stats.options.Show(option);
  lines.push_back("all settings:" + settings);
  if (stats.options.render.crop) lines.push_back(CropLine(stats.options.render));
  if (world.scene().has_default_camera) lines.emplace_back("the scene has no camera: the default camera is used");
  if (world.scene().has_default_lights) {
    const bool is_lit_by_itself = stats.options.render.mode == RenderMode::path && LightsOfPath(world).empty();
    lines.emplace_back(is_lit_by_itself ? "the scene has no lights: its emissive surfaces light it"
                                        : "the scene has no lights: the default lights are used");
  }
  for (const std::string& line : stats.scene.settings) lines.push_back("set by the scene: " + line);
  return lines;
}

/// Returns the number of parts into which the image may be divided, on machines like this one, before reading and
/// building the scene again for each becomes too expensive.
std::string ExplainParts(const RunStats& stats) {
  constexpr double most_overhead = 0.05;
  const double again = stats.seconds.load + stats.seconds.build;
  const double parts = again > 0 ? most_overhead * stats.seconds.render / again : most_image_parts;
  return "parts: each repeats " + Rounded(again, 2) + " s of reading and building; " +
         (parts < 2 ? "even two of them lose more than 5% to that"
                    : "up to " + Rounded(std::floor(std::min<double>(parts, most_image_parts)), 7) +
                          " lose less than 5% to that");
}

}  // namespace

RunLog::RunLog(std::span<const std::string> words) { stats_.command = CommandAsTyped(words); }

void RunLog::Loaded(const ParsedScene& parsed, RenderOptions all) {
  stats_.options = std::move(all);
  const RenderOptions& options = stats_.options;
  stats_.image_file = options.files.image;
  stats_.threads = ThreadsOf(options.render);
  stats_.scene.settings = SettingsInForce(parsed.scene, options);
  stats_.seconds.load = watch_.Lap();
  if (options.render.trace.max_depth > most_bounces)
    Warn("raypro: warning: -max_depth " + std::to_string(options.render.trace.max_depth) +
         " exceeds the hard limit of " + std::to_string(most_bounces) + " bounces");
  for (const std::string& line : OptionsWithoutEffect(options)) Warn("raypro: warning: " + line);
  for (const std::string& line : parsed.warnings) Warn(line);
  stats_.scene.hash = SceneHash(parsed.scene.files);
  stats_.scene.lights = static_cast<std::int64_t>(parsed.scene.lights.size());
  PrintStep("read " + Counted(parsed.scene.files.size(), "file"), stats_.seconds.load);
  watch_.Lap();
}

void RunLog::Built(const World& world, const Accelerator& accelerator, bool shares_light) {
  stats_.options.render.shares_light = shares_light;
  stats_.seconds.build = watch_.Lap();
  for (const std::string& line : world.Warnings()) Warn(line);
  for (const std::string& line : PlainMistakes(world, stats_.options.render)) Warn(line);
  for (const std::string& line : RenderHints(world, accelerator, stats_.options.render)) Hint(line);
  stats_.scene.nodes = static_cast<std::int64_t>(world.Nodes().size());
  stats_.scene.instances = static_cast<std::int64_t>(world.Instances().size());
  stats_.scene.primitives = world.Primitives();
  stats_.accelerator = accelerator.kind;
  stats_.structure_bytes = accelerator.Bytes();
  const SceneFeatures needs = FeaturesOf(world, stats_.options.render);
  stats_.needs = needs.Names();
  stats_.kernel = KernelName(needs, stats_.options.render);
  stats_.biased = SourcesOfBias(needs, stats_.options.render);
  if (stats_.options.explain) {
    for (const std::string& line : accelerator.reasons) PrintError("raypro: " + line);
    for (const std::string& line : accelerator.Explain()) PrintError("raypro: " + line);
    for (const std::string& line : ExplainRender(world, stats_)) PrintError("raypro: " + line);
  }
  PrintStep(
      "built " + accelerator.kind + " over " + Counted(static_cast<std::uint64_t>(world.Primitives()), "primitive"),
      stats_.seconds.build);
}

void RunLog::Compared(double true_error) { stats_.true_error = true_error; }

void RunLog::WillFinishIn(const Budget& budget) {
  const RenderSettings& render = stats_.options.render;
  const double so_far = SecondsSoFar();
  const auto warn_if_too_long = [&](double seconds, const std::string& work, const std::string& consequence) {
    if (so_far + seconds <= budget.seconds) return;
    const std::string reason =
        seconds > budget.seconds
            ? work + " " + PixelsAcross(render) + " pixels alone takes about " + Rounded(seconds, 2) + " s"
            : ": what comes before the first ray took " + Rounded(so_far, 2) + " s";
    Warn("raypro: warning: -time " + ShowDuration(budget.seconds) + " is too short" + reason + consequence);
  };
  warn_if_too_long(budget.seconds_to_finish, ": filling and writing", "");
  if (render.denoise)
    warn_if_too_long(budget.seconds_to_filter + budget.seconds_to_finish, " for -denoise: filtering and writing",
                     "; the image will not be denoised");
}

void RunLog::Rendered(const RenderResult& result) {
  stats_.seconds.render = watch_.Lap();
  stats_.seconds.wall = watch_.Total();
  stats_.Take(result);
  if (stats_.options.explain && result.IsComplete()) PrintError("raypro: " + ExplainParts(stats_));
  if (!result.IsComplete()) stats_.stopped_by = StopSignalName();
  const RenderSettings& render = stats_.options.render;
  constexpr std::int64_t fewest = 1000;  // for which 0.1 % is one pixel
  if (result.has_outliers && result.pixels_total >= fewest)
    Warn(
        "raypro: warning: 0.1% of the pixels hold more than half of the squared error; where light is found so "
        "rarely, the true error may be larger than estimated");
  if (result.error && result.error->IsMostlyUnseen() && (render.budget.IsOpen() || render.denoise))
    Warn(
        "raypro: warning: no path from a surface to a lamp by way of mirrors or glass was found; caustics that are so "
        "rare may make the true error larger than estimated, up to " +
        ErrorText(result.error->high, result.error->unit));
  if (result.MissesLight())
    Hint("raypro: warning: " + Rounded(100 * result.share_cut, 2) + "% of the light ended at " + LimitsOfLight(stats_) +
         "; the image is about that much too dark");
  if (result.rays.cut > 0)
    Warn("raypro: warning: " + Counted(result.rays.cut, "ray") + " were terminated; a camera ray may have at most " +
         std::to_string(most_descendants) + " descendants");
  PrintStep("traced " + Counted(result.rays.Total(), "ray"), stats_.seconds.render);
  if (!result.denoise_failure.empty()) Warn("raypro: the image is not denoised: " + result.denoise_failure);
  if (result.had_no_time_to_denoise)
    Warn("raypro: warning: the image is not denoised: -time " + ShowDuration(render.budget.seconds) +
         " left too little for two samples per pixel and their filter");
  if (result.is_better_noisy)
    Hint("raypro: the image is not denoised: its error is below the target as it is, and would be above it denoised");
  if (result.error_before_denoising) PrintStep("of that, denoised", result.denoise_seconds);
}

void RunLog::ExplainIfBlack(const World& world, const Accelerator& accelerator, const R2::Image& image) {
  const RenderSettings& render = stats_.options.render;
  const bool shows_all = ShowsLight(render.mode) && !render.crop && stats_.IsComplete();
  if (shows_all && !world.Instances().empty() && IsLit(world) && IsWhollyBlack(image))
    Hint("raypro: warning: the image is black; " + WhyBlack(world, accelerator, render));
}

void RunLog::Written(const std::string& image_file) {
  stats_.image_file = image_file;
  const bool has_file = stats_.options.files.image != standard_stream;
  stats_.seconds.write = watch_.Lap();
  stats_.seconds.wall = watch_.Total();
  if (shared_before_) stats_.seconds.shared = *shared_before_ + stats_.seconds.wall;
  stats_.seconds.cpu = CpuSeconds();
  stats_.peak_memory = PeakMemory();
  PrintStep("wrote the image", stats_.seconds.write);
  if (stats_.pixels_done == 0)
    PrintError("raypro: stopped before the first pixel; there is no image to save");
  else if (!stats_.IsComplete() && has_file && image_file != stats_.options.files.image)
    PrintError("raypro: " + QuotedPath(stats_.options.files.image) + " is unchanged; the image so far is " +
               QuotedPath(image_file));
  if (!stats_.IsComplete() && !stats_.options.files.layers.empty())
    PrintError("raypro: -layers are rendered once the image is complete; none are written");
  if (!stats_.IsComplete() && has_file) PrintError("raypro: progress saved; -resume continues from it");
}

// The image is safe by now, so the run fails only if requested information could not be printed.
void RunLog::Summarize() const {
  // If the image goes to standard output, text goes to standard error.
  const auto write = stats_.options.files.image == standard_stream ? PrintErrorPart : WriteStandardOutput;
  if (stats_.options.stats) write(Statistics(stats_));
  try {
    if (!stats_.options.quiet && stats_.pixels_done > 0) write(FinalLine(stats_) + QualityLines(stats_));
  } catch (const OutputError& error) {
    PrintError("raypro: " + std::string(error.what()));
  }
}

void RunLog::Warn(const std::string& line) {
  PrintError(line);
  stats_.warnings.push_back(line);
}

void RunLog::Hint(const std::string& line) {
  if (!stats_.options.quiet) PrintError(line);
  stats_.warnings.push_back(line);
}

void RunLog::PrintStep(const std::string& step, double seconds) const {
  if (stats_.options.verbose) PrintError(step + " in " + Fixed(seconds, 3) + " s");
}

}  // namespace ray

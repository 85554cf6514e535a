#include "source/app/report/RunLog.h"

#include <signal.h>

#include <algorithm>
#include <initializer_list>
#include <tuple>
#include <utility>

#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/files/SceneHash.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/PictureName.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/Check.h"
#include "source/app/report/Messages.h"
#include "source/integrate/lights/LightSource.h"
#include "source/render/SceneFeatures.h"
#include "source/render/Schedule.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// "without -aperture and -sampler grid": those of what an option needs that are not there.
std::string Without(std::initializer_list<std::pair<bool, const char*>> needed) {
  std::string text;
  for (const auto& [is_there, what] : needed)
    if (!is_there) text += (text.empty() ? "without " : " and ") + std::string(what);
  return text;
}

/// "-focus has no effect without -aperture": options that were typed and this picture, or this accelerator, makes no
/// use of.
std::vector<std::string> OptionsWithoutEffect(const Options& options) {
  const R2::ImageFormat* format = FormatOfPicture(options.picture);
  const std::string kind = format ? format->name : "", on_format = "on the format " + kind;
  const RenderSettings& render = options.render;
  const bool is_grid = IsGrid(render.trace.sampler), has_lens = render.camera.HasLens();
  const bool is_spiral = render.camera.lens != LensPattern::random;
  const std::pair lens{has_lens, "-aperture"}, grid{is_grid, "-sampler grid"};
  const std::string& accel = options.accelerator.name;
  const bool is_graph = accel == "graph";
  const bool has_colored_lamps =
      render.mode == RenderMode::whitted || (render.mode == RenderMode::path && !EmitsRadiance(render));
  const bool has_error = render.budget.IsOpen() || render.denoise || options.stats || !options.report.empty() ||
                         !options.reference.empty();
  const std::string with_accelerator = "with -accel " + options.accelerator.name;
  const std::tuple<const char*, bool, std::string> uses[] = {
      {"bits", kind == "png", on_format},
      {"jpeg_quality", kind == "jpeg", on_format},
      {"bytes", format && !format->is_linear, on_format},
      {"denoiser", render.denoise, "without -denoise"},
      {"filter", !IsSubsampled(render), "where pixels have at most one sample, at their centers"},
      {"focus", has_lens, "without -aperture"},
      {"lens", has_lens && is_grid, Without({lens, grid})},
      {"lens_samples", has_lens && is_grid && is_spiral, Without({lens, grid, {is_spiral, "-lens spiral"}})},
      {"shutter_samples", is_grid, "without -sampler grid"},
      {"zbuffer_range", render.mode == RenderMode::zbuffer, "without -mode zbuffer"},
      {"gooch", render.mode == RenderMode::gooch, "without -mode gooch"},
      {"toon_bands", render.mode == RenderMode::toon, "without -mode toon"},
      {"emission", render.mode == RenderMode::path, "without -mode path"},
      {"emissive_meshes", has_colored_lamps, "without -mode whitted or -emission color"},
      {"emissive_solids", has_colored_lamps, "without -mode whitted or -emission color"},
      {"adaptive", render.budget.adaptive != Adaptive::tile || render.budget.error, "without -error"},
      {"adaptive", render.budget.adaptive != Adaptive::neighbors || render.samples > 1, "without -samples"},
      {"samples", render.samples > 1 || !render.budget.IsOpen(), "with -time or -error unless it is 2 or more"},
      {"strategy", render.mode == RenderMode::path, "without -mode path"},
      {"confidence", has_error, "without -error, -time, -denoise, -reference, -stats or -report"},
      {"out_format", !options.out_folder.empty(), "without -out_folder"},
      {"accel_res", accel != "none" && !is_graph, with_accelerator},
      {"accel_res", accel != "bvh" || options.accelerator.resolution <= 8, "above 8 with -accel bvh"},
      {"accel_depth", accel == "octree", with_accelerator},
      {"node_boxes", is_graph, with_accelerator},
      {"front_to_back", is_graph, with_accelerator},
      {"last_hit", is_graph, with_accelerator},
  };
  std::vector<std::string> lines;
  for (const auto& [option, is_used, why] : uses)
    if (options.IsGiven(option) && !is_used) lines.push_back("-" + std::string(option) + " has no effect " + why);
  if (options.IsGiven("samples") && render.samples > 1 && render.samples % 2 == 1 && HasTwoStreams(render))
    lines.push_back("-samples " + std::to_string(render.samples) +
                    ": errors are told by comparing two halves, so that " + std::to_string(render.samples - 1) +
                    " are taken");
  return lines;
}

/// "8192x8192", of the crop where there is one.
std::string PixelsAcross(const RenderSettings& render) {
  const PixelRectangle part = render.crop.value_or(PixelRectangle{0, 0, render.width, render.height});
  return std::to_string(part.Width()) + "x" + std::to_string(part.Height());
}

/// What -crop changes, and what is rendered for its sake.
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
  for (const OptionKind& option : OptionTable(stats.options.program))
    if (IsSetting(option) && std::string(option.topic) != "messages" && !Show(option, stats.options).empty())
      settings += " -" + std::string(option.name) + " " + Show(option, stats.options);
  lines.push_back("all settings:" + settings);
  if (stats.options.render.crop) lines.push_back(CropLine(stats.options.render));
  if (world.scene().has_default_camera) lines.emplace_back("the scene names no camera: the default one is used");
  if (world.scene().has_default_lights) {
    const bool is_lit_by_itself = stats.options.render.mode == RenderMode::path && LightsOfPath(world).empty();
    lines.emplace_back(is_lit_by_itself ? "the scene names no light: what emits lights it"
                                        : "the scene names no light: the default ones shine");
  }
  for (const std::string& line : stats.scene.settings) lines.push_back("set by the scene: " + line);
  return lines;
}

/// Says how many parts the image may be cut into, on machines like this one, before reading and building the scene
/// again for each costs too much.
std::string ExplainParts(const RunStats& stats) {
  constexpr double most_overhead = 0.05;
  const double again = stats.seconds.load + stats.seconds.build;
  const double parts = again > 0 ? most_overhead * stats.seconds.render / again : most_image_parts;
  return "parts: each reads and builds for " + Rounded(again, 2) + " s again; " +
         (parts < 2 ? "two of them already lose more than 5 % to that"
                    : "up to " + Rounded(std::floor(std::min<double>(parts, most_image_parts)), 7) +
                          " lose less than 5 % to that");
}

}  // namespace

RunLog::RunLog(const Options& options, std::span<const std::string> words) {
  stats_.options = options;
  stats_.picture = options.picture;
  stats_.command = CommandAsTyped(words);
  stats_.threads = ThreadsOf(options.render);
}

void RunLog::Loaded(const ParsedScene& parsed, const Options& options) {
  stats_.options = options;
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

void RunLog::Built(const World& world, const Accelerator& accelerator) {
  stats_.seconds.build = watch_.Lap();
  for (const std::string& line : world.Warnings()) Warn(line);
  for (const std::string& line : PlainMistakes(world, stats_.options.render)) Warn(line);
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
  if (!result.IsComplete()) stats_.stop = StopSignal() == SIGTERM ? "SIGTERM" : "SIGINT";
  const RenderSettings& render = stats_.options.render;
  constexpr std::int64_t fewest = 1000;  // of whose pixels 0.1 % is one
  if (result.has_outliers && result.pixels_total >= fewest)
    Warn(
        "raypro: warning: 0.1 % of the pixels hold more than half of the squared error; where light is found so "
        "rarely, the true error may be larger than estimated");
  if (result.error && result.error->IsMostlyUnseen() && (render.budget.IsOpen() || render.denoise))
    Warn(
        "raypro: warning: no path from a surface to a lamp by way of mirrors or glass was found; caustics that are so "
        "rare may make the true error larger than estimated, up to " +
        ErrorText(result.error->high, result.error->unit));
  if (result.rays.cut > 0)
    Warn("raypro: warning: " + Counted(result.rays.cut, "ray") + " were terminated; a camera ray may have at most " +
         std::to_string(most_descendants) + " descendants");
  PrintStep("traced " + Counted(result.rays.Total(), "ray"), stats_.seconds.render);
  if (!result.denoise_failure.empty()) Warn("raypro: the image is not denoised: " + result.denoise_failure);
  if (result.had_no_time_to_denoise)
    Warn("raypro: warning: the image is not denoised: -time " + ShowDuration(render.budget.seconds) +
         " left too little for two samples per pixel and their filter");
  if (result.error_before_denoising) PrintStep("of that, denoised", result.denoise_seconds);
}

void RunLog::Written(const std::string& picture) {
  stats_.picture = picture;
  const bool has_file = stats_.options.picture != standard_stream;
  stats_.seconds.write = watch_.Lap();
  stats_.seconds.wall = watch_.Total();
  if (shared_before_) stats_.seconds.shared = *shared_before_ + stats_.seconds.wall;
  stats_.seconds.cpu = CpuSeconds();
  stats_.peak_memory = PeakMemory();
  PrintStep("wrote the picture", stats_.seconds.write);
  if (stats_.pixels_done == 0)
    PrintError("raypro: stopped before the first pixel; there is no picture to save");
  else if (!stats_.IsComplete() && has_file && picture != stats_.options.picture)
    PrintError("raypro: " + QuotedPath(stats_.options.picture) + " is left as it was; the picture so far is " +
               QuotedPath(picture));
  if (!stats_.IsComplete() && !stats_.options.layers.empty())
    PrintError("raypro: -layers are rendered once the picture is complete; none are written");
  if (!stats_.IsComplete() && has_file) PrintError("raypro: progress saved; -resume continues from it");
}

// The picture is safe by now, so the run fails only where what was asked for could not be told.
void RunLog::Summarize() const {
  // Where the picture takes standard output, words go to standard error.
  const auto write = stats_.options.picture == standard_stream ? TellPart : WriteStandardOutput;
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

void RunLog::PrintStep(const std::string& step, double seconds) const {
  if (stats_.options.verbose) PrintError(step + " in " + Fixed(seconds, 3) + " s");
}

}  // namespace ray

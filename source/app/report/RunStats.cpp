#include "source/app/report/RunStats.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <tuple>

#include "source/app/options/RayproCommand.h"
#include "source/render/SceneFeatures.h"
#include "source/render/forecast/ErrorForecast.h"
#include "source/scene/CameraText.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

std::string ShortCountText(double count) { return count == std::floor(count) ? CountText(count) : Fixed(count, 1); }

std::string PixelsText(const RunStats& stats) {
  if (stats.IsComplete() && !IsSubsampled(stats.options.render)) return "complete";
  if (stats.IsComplete())
    return "complete: " + std::to_string(stats.pixels_done) + " of " + std::to_string(stats.pixels_total) +
           " pixels traced, the others interpolated";
  if (stats.pixels_done < stats.pixels_total)
    return std::to_string(stats.pixels_done) + " of " + std::to_string(stats.pixels_total) + " pixels done";
  const bool is_known = !stats.options.render.budget.IsOpen() && stats.options.files.replay.empty();
  const std::string wanted = is_known ? " of " + std::to_string(stats.options.render.samples) : "";
  return ShortCountText(stats.samples.mean) + wanted + " samples per pixel done";
}

/// Returns the samples per pixel: the requested number, or the actual one if a clock, an error or a signal ended the
/// render.
double SamplesOf(const RunStats& stats) {
  const RenderSettings& render = stats.options.render;
  const bool is_asked_for = !render.budget.IsOpen() && !render.denoise && stats.options.files.replay.empty();
  return is_asked_for && stats.IsComplete() && !IsSubsampled(render) ? render.samples : stats.samples.mean;
}

/// Returns "16 spp" or "1 spp at 3.1% of the pixels, the others interpolated,".
std::string SppText(const RunStats& stats) {
  const double samples = SamplesOf(stats);
  if (samples < 1) return "1 spp at " + Fixed(100 * samples, 1) + "% of the pixels, the others interpolated,";
  return ShortCountText(samples) + " spp";
}

double MegaraysPerSecond(const RunStats& stats) {
  const auto rays = static_cast<double>(stats.rays.Total() - stats.rays_before);
  return stats.seconds.wall > 0 ? 1e-6 * rays / stats.seconds.wall : 0;
}

std::string Seconds(double seconds) { return Fixed(seconds, 3) + " s"; }

/// Returns a row of the table "tests per ray".
std::string CostPerRay(const RayCounts::Kind& kind) {
  std::string row;
  const auto column = [&](std::uint64_t number, std::size_t width) {
    const std::string text = Fixed(static_cast<double>(number) / static_cast<double>(kind.rays), 2);
    row += std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
  };
  column(kind.cost.node_visits, 7);
  column(kind.cost.box_tests, 10);
  column(kind.cost.primitive_tests, 12);
  column(kind.cost.hits, 8);
  return row;
}

/// Returns " (too dark by about 2%)" if settings cut off light.
std::string DarknessText(const RunStats& stats) {
  return stats.share_cut > 0 ? " (too dark by about " + Rounded(100 * stats.share_cut, 2) + "%)" : "";
}

/// Returns "-max_depth 3, -sampler grid", of the settings that cut light off or of the others.
std::string BiasText(const RunStats& stats, bool cuts_light) {
  std::string list;
  for (const std::string& setting : stats.biased) {
    if (setting == "denoise") continue;  // printed with the error
    if (CutsLight(setting) == cuts_light) list += (list.empty() ? "-" : ", -") + setting;
  }
  return list;
}

/// Returns "; limited by -max_depth 3, -min_luminance 0.01 (too dark by about 2%), biased by -adaptive tile"; empty if
/// there are no limits.
std::string LimitsText(const RunStats& stats) {
  const std::string cut = stats.share_cut > 0 ? BiasText(stats, true) : "", moved = BiasText(stats, false);
  return (cut.empty() ? "" : "; limited by " + cut + DarknessText(stats)) +
         (moved.empty() ? "" : (cut.empty() ? "; biased by " : ", biased by ") + moved);
}

/// Returns ", nu 12: few pixels hold the error, and the truth itself varies by 41%", two standard deviations of the
/// root of a mean square of that many values; empty if there are many.
std::string FreedomText(const ErrorEstimate& error) {
  constexpr double many = 270;  // from there on nine of ten claims are within 10% of the truth
  if (!(error.freedom < many)) return {};
  return ", nu " + Fixed(error.freedom, 0) + ": few pixels hold the error, and the truth itself varies by " +
         Fixed(100 * std::min(1.0, 2 / std::sqrt(2 * error.freedom)), 0) + "%";
}

/// Returns true if a library denoised the image, since other versions may produce other images.
bool IsDenoisedByLibrary(const RunStats& stats) {
  return !stats.denoised_by.empty() && stats.options.render.denoiser != Denoiser::regression;
}

/// Returns " by Open Image Denoise 2.5.1"; empty for our own filter.
std::string DenoiserText(const RunStats& stats) { return IsDenoisedByLibrary(stats) ? " by " + stats.denoised_by : ""; }

std::string StopText(const RunStats& stats) {
  const bool has_stalled = stats.stop == Stop::stall;
  return (has_stalled ? "an error that does not fall" : stats.stopped_by) +
         (stats.seconds.shared > 0 ? " after " + Fixed(stats.seconds.shared, 2) + " s" : "");
}

/// Returns the predicted samples for a requested error that was not reached.
std::string ForecastText(const RunStats& stats) {
  const auto& target = stats.options.render.budget.error;
  const auto forecast = target ? ForecastOf(stats.passes, *target) : std::nullopt;
  if (!forecast || !(forecast->samples > stats.samples.mean)) return {};
  constexpr double most = 1e9;  // samples that a render takes
  return (forecast->samples < most ? ", about " + Rounded(forecast->samples, 2) : ", more than 1e9") + " for " +
         ErrorText(target->value, target->unit);
}

std::string Listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list.empty() ? "none" : list;
}

template <typename Line>
std::string ErrorLines(const RunStats& stats, const Line& line) {
  if (!stats.error) return {};
  const ErrorEstimate& e = *stats.error;
  const PixelRectangle& w = e.worst_block_at;
  std::string text =
      line(stats.error_before_denoising ? "error, denoised"
           : stats.two_streams          ? "error"
                                        : "error, at most",
           ErrorText(e.estimate, e.unit) + ", " + ErrorText(e.low, e.unit) + " to " + ErrorText(e.high, e.unit)) +
      line("worst block", ErrorText(e.worst_block, e.unit) + " at " + std::to_string(w.x0) + " " +
                              std::to_string(w.y0) + " " + std::to_string(w.x1) + " " + std::to_string(w.y1)) +
      line("outliers", Fixed(100 * e.outlier_share, 1) + "% of it in the worst 0.1% of the pixels");
  if (stats.true_error) text += line("true error", ErrorText(*stats.true_error, e.unit));
  if (const auto& before = stats.error_before_denoising)
    text +=
        line("denoised by", stats.denoised_by) + line("before denoising", ErrorText(before->estimate, before->unit));
  return text;
}

/// Returns "rays saved: 153600 of 360000 camera rays, where neighboring pixels are alike".
std::string SavedText(const RunStats& stats) {
  const double pixels = static_cast<double>(stats.pixels_total);
  const double all = pixels * stats.planned_samples, saved = all - pixels * stats.samples.mean;
  return "rays saved: " + Fixed(saved, 0) + " of " + Fixed(all, 0) +
         " camera rays, where neighboring pixels are alike\n";
}

}  // namespace

void RunStats::Take(const RenderResult& result) {
  RenderSummary::operator=(result);
  width = result.image.Width();
  height = result.image.Height();
  stopped_by = stop_names[static_cast<std::size_t>(result.stop)];
}

int ThreadsOf(const RenderSettings& settings) {
  if (settings.threads > 0) return settings.threads;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

std::string CommandAsTyped(std::span<const std::string> words) {
  return words.empty() ? "raypro" : "raypro " + ShellLine(words);
}

R2::ImageSettings SettingsInImage(const RunStats& stats) {
  R2::ImageSettings settings{
      {"program", "raypro " RAYPRO_VERSION},
      {"command", stats.options.as_course ? stats.command : RayproCommand(stats.options)},
      {"scene_hash", stats.scene.hash},
      {"seed", std::to_string(stats.options.render.seed)},
      {"samples", CountText(SamplesOf(stats))},  // a weight for programs that merge images
      {"accel", stats.options.accelerator.name},
      {"pixels", PixelsText(stats)},
  };
  if (IsDenoisedByLibrary(stats)) settings["denoised_by"] = stats.denoised_by;
  if (stats.options.keep_times) {
    settings["seconds"] = Fixed(stats.seconds.wall, 3);
    settings["threads"] = std::to_string(stats.threads);
  }
  if (const auto& view = stats.options.render.view) settings["camera"] = CameraLine(*view);
  for (const std::string& setting : stats.scene.settings)
    settings["scene_settings"] += (settings["scene_settings"].empty() ? "" : ", ") + setting;
  return settings;
}

std::string LimitsOfLight(const RunStats& stats) { return BiasText(stats, true); }

std::string FinalLine(const RunStats& stats) {
  return Escaped(stats.image_file) + " " + std::to_string(stats.width) + "x" + std::to_string(stats.height) + " " +
         SppText(stats) + " " + Fixed(stats.seconds.wall, 2) + " s " + Fixed(MegaraysPerSecond(stats), 1) + " Mrays/s" +
         (stats.IsComplete() ? "" : " (stopped by " + stats.stopped_by + ", " + PixelsText(stats) + ")") + "\n";
}

std::string QualityLines(const RunStats& stats) {
  const bool is_asked = stats.options.render.budget.IsOpen() || stats.options.render.denoise || stats.true_error;
  if (!is_asked) return SamplesWhereNeighborsDiffer(stats.options.render) && stats.IsComplete() ? SavedText(stats) : "";
  std::string text;
  if (stats.error) {
    const ErrorEstimate& e = *stats.error;
    text = std::string(stats.two_streams ? "estimated error " : "estimated error at most ") +
           ErrorText(e.estimate, e.unit) + " (" + Rounded(100 * stats.options.render.budget.confidence, 6) +
           "%: " + Rounded(e.low, 3) + " to " + Rounded(e.high, 3) + FreedomText(e) + ")";
    if (const auto& before = stats.error_before_denoising)
      text += " denoised" + DenoiserText(stats) + ", " + ErrorText(before->estimate, before->unit) + " before";
    if (stats.true_error) text += ", true error " + ErrorText(*stats.true_error, e.unit);
    text += "; ";
  } else if (stats.true_error) {
    text = "true error " + ErrorText(*stats.true_error, ErrorUnit::display) + "; ";
  }
  return text + "stopped by " + StopText(stats) + " at " + Fixed(stats.samples.mean, 1) + " samples per pixel" +
         ForecastText(stats) + LimitsText(stats) + "\n";
}

std::string Statistics(const RunStats& stats) {
  const auto line = [](std::string name, const std::string& value) {
    constexpr std::size_t column_of_values = 18;
    name.resize(column_of_values, ' ');
    return "  " + name + value + "\n";
  };
  const auto count = [&](const char* name, auto number) { return line(name, std::to_string(number)); };
  const auto& [scene, rays, seconds] = std::tie(stats.scene, stats.rays, stats.seconds);
  std::string kinds, costs;
  for (std::size_t i = 0; i < ray_kind_names.size(); ++i) {
    const RayCounts::Kind& kind = rays.kinds[i];
    kinds += count(ray_kind_names[i], kind.rays);
    if (kind.rays > 0) costs += line(ray_kind_names[i], CostPerRay(kind));
  }
  const Counts cost = rays.Cost();
  return "scene\n" + line("hash", scene.hash) + count("nodes", scene.nodes) + count("instances", scene.instances) +
         count("primitives", scene.primitives) + count("lights", scene.lights) + "rays\n" + kinds +
         count("terminated", rays.cut) + count("invalid", cost.bad_rays) + count("total", rays.Total()) +
         (stats.guide_rays > 0 ? count("  for guides", stats.guide_rays) : "") + "tests\n" +
         count("nodes", cost.node_visits) + count("boxes", cost.box_tests) + count("primitives", cost.primitive_tests) +
         count("hits", cost.hits) + count("last-hit lookups", cost.cache_tests) +
         count("last-hit hits", cost.cache_hits) + "tests per ray       nodes     boxes  primitives    hits\n" + costs +
         "time\n" + line("load", Seconds(seconds.load)) + line("build", Seconds(seconds.build)) +
         line("render", Seconds(seconds.render)) +
         (stats.denoise_seconds > 0
              ? line("  denoise", Seconds(stats.denoise_seconds)) + line("    guides", Seconds(stats.guide_seconds))
              : "") +
         line("write", Seconds(seconds.write)) + line("wall", Seconds(seconds.wall)) +
         line("cpu", Seconds(seconds.cpu)) + "run\n" + count("threads", stats.threads) +
         line("accelerator", stats.accelerator + " (-accel " + stats.options.accelerator.name + ")") +
         line("structure", Fixed(1e-6 * static_cast<double>(stats.structure_bytes), 1) + " MB") +
         line("peak memory", Fixed(1e-6 * static_cast<double>(stats.peak_memory), 1) + " MB") +
         line("pixels", std::to_string(stats.pixels_done) + " of " + std::to_string(stats.pixels_total)) +
         line("kernel", stats.kernel) + "image\n" +
         line("samples", std::to_string(stats.samples.least) + " to " + std::to_string(stats.samples.most) +
                             " per pixel, mean " + Fixed(stats.samples.mean, 2)) +
         ErrorLines(stats, line) + line("bias from", Listed(stats.biased) + DarknessText(stats)) +
         line("stopped", stats.stopped_by);
}

}  // namespace ray

#include "source/app/report/RunStats.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <tuple>

#include "source/app/options/RayproCommand.h"
#include "source/render/forecast/ErrorForecast.h"
#include "source/scene/CameraText.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

std::string ShortCountText(double count) { return count == std::floor(count) ? CountText(count) : Fixed(count, 1); }

std::string PixelsText(const RunStats& record) {
  if (record.IsComplete() && !IsSubsampled(record.options.render)) return "complete";
  if (record.IsComplete())
    return "complete: " + std::to_string(record.pixels_done) + " of " + std::to_string(record.pixels_total) +
           " pixels traced, the others interpolated";
  if (record.pixels_done < record.pixels_total)
    return std::to_string(record.pixels_done) + " of " + std::to_string(record.pixels_total) + " pixels done";
  const bool is_known = !record.options.render.budget.IsOpen() && record.options.files.replay.empty();
  const std::string wanted = is_known ? " of " + std::to_string(record.options.render.samples) : "";
  return ShortCountText(record.samples.mean) + wanted + " samples per pixel done";
}

/// Per pixel: as asked for, where that decided; as they became, where a clock, an error or a signal did.
double SamplesOf(const RunStats& record) {
  const RenderSettings& render = record.options.render;
  const bool is_asked_for = !render.budget.IsOpen() && !render.denoise && record.options.files.replay.empty();
  return is_asked_for && record.IsComplete() && !IsSubsampled(render) ? render.samples : record.samples.mean;
}

/// "16 spp", "1 spp at 3.1% of the pixels, the others interpolated,"
std::string SppText(const RunStats& record) {
  const double samples = SamplesOf(record);
  if (samples < 1) return "1 spp at " + Fixed(100 * samples, 1) + "% of the pixels, the others interpolated,";
  return ShortCountText(samples) + " spp";
}

double MegaraysPerSecond(const RunStats& record) {
  const auto rays = static_cast<double>(record.rays.Total() - record.rays_before);
  return record.seconds.wall > 0 ? 1e-6 * rays / record.seconds.wall : 0;
}

std::string Seconds(double seconds) { return Fixed(seconds, 3) + " s"; }

/// A row of the table under "tests per ray".
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

/// " (too dark by about 2%)" where settings cut off light.
std::string DarknessText(const RunStats& record) {
  return record.share_cut > 0 ? " (too dark by about " + Rounded(100 * record.share_cut, 2) + "%)" : "";
}

bool CutsLight(const std::string& setting) {
  return setting.starts_with("max_depth") || setting.starts_with("min_luminance");
}

/// "-max_depth 3, -sampler grid", of the settings that cut light off or of the others.
std::string BiasText(const RunStats& record, bool cuts_light) {
  std::string list;
  for (const std::string& setting : record.biased) {
    if (setting == "denoise") continue;  // printed with the error
    if (CutsLight(setting) == cuts_light) list += (list.empty() ? "-" : ", -") + setting;
  }
  return list;
}

/// "; limited by -max_depth 3, -min_luminance 0.01 (too dark by about 2%), biased by -adaptive tile"; nothing for no
/// limits.
std::string LimitsText(const RunStats& record) {
  const std::string cut = record.share_cut > 0 ? BiasText(record, true) : "", moved = BiasText(record, false);
  return (cut.empty() ? "" : "; limited by " + cut + DarknessText(record)) +
         (moved.empty() ? "" : (cut.empty() ? "; biased by " : ", biased by ") + moved);
}

/// ", nu 12: few pixels hold the error, and the truth itself varies by 41%", two deviations of a root of a mean square
/// of so many values; nothing where they are many.
std::string FreedomText(const ErrorEstimate& error) {
  constexpr double many = 270;  // from there on nine of ten claims are within 10% of the truth
  if (!(error.freedom < many)) return {};
  return ", nu " + Fixed(error.freedom, 0) + ": few pixels hold the error, and the truth itself varies by " +
         Fixed(100 * std::min(1.0, 2 / std::sqrt(2 * error.freedom)), 0) + "%";
}

/// Another version of a library may make another picture.
bool IsDenoisedByLibrary(const RunStats& record) {
  return !record.denoised_by.empty() && record.options.render.denoiser != Denoiser::regression;
}

/// " by Open Image Denoise 2.5.1"; nothing for our own filter.
std::string DenoiserText(const RunStats& record) {
  return IsDenoisedByLibrary(record) ? " by " + record.denoised_by : "";
}

std::string StopText(const RunStats& record) {
  const bool has_stalled = record.stop == Stop::stall;
  return (has_stalled ? "an error that does not fall" : record.stopped_by) +
         (record.seconds.shared > 0 ? " after " + Fixed(record.seconds.shared, 2) + " s" : "");
}

/// What an error that was asked for and not reached would take.
std::string ForecastText(const RunStats& record) {
  const auto& target = record.options.render.budget.error;
  const auto forecast = target ? ForecastOf(record.passes, *target) : std::nullopt;
  if (!forecast || !(forecast->samples > record.samples.mean)) return {};
  constexpr double most = 1e9;  // that a render takes
  return (forecast->samples < most ? ", about " + Rounded(forecast->samples, 2) : ", more than 1e9") + " for " +
         ErrorText(target->value, target->unit);
}

std::string Listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list.empty() ? "none" : list;
}

template <typename Line>
std::string ErrorLines(const RunStats& record, const Line& line) {
  if (!record.error) return {};
  const ErrorEstimate& e = *record.error;
  const PixelRectangle& w = e.worst_block_at;
  std::string text =
      line(record.error_before_denoising ? "error, denoised"
           : record.two_streams          ? "error"
                                         : "error, at most",
           ErrorText(e.estimate, e.unit) + ", " + ErrorText(e.low, e.unit) + " to " + ErrorText(e.high, e.unit)) +
      line("worst block", ErrorText(e.worst_block, e.unit) + " at " + std::to_string(w.x0) + " " +
                              std::to_string(w.y0) + " " + std::to_string(w.x1) + " " + std::to_string(w.y1)) +
      line("outliers", Fixed(100 * e.outlier_share, 1) + "% of it in the worst 0.1% of the pixels");
  if (record.true_error) text += line("true error", ErrorText(*record.true_error, e.unit));
  if (const auto& before = record.error_before_denoising)
    text +=
        line("denoised by", record.denoised_by) + line("before denoising", ErrorText(before->estimate, before->unit));
  return text;
}

/// "rays saved: 153600 of 360000 camera rays, where neighboring pixels are alike"
std::string SavedText(const RunStats& record) {
  const double pixels = static_cast<double>(record.pixels_total);
  const double all = pixels * record.planned_samples, saved = all - pixels * record.samples.mean;
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

R2::ImageSettings SettingsInPicture(const RunStats& record) {
  R2::ImageSettings settings{
      {"program", "raypro " RAYPRO_VERSION},
      {"command", record.options.as_course ? record.command : RayproCommand(record.options)},
      {"scene_hash", record.scene.hash},
      {"seed", std::to_string(record.options.render.seed)},
      {"samples", CountText(SamplesOf(record))},  // a weight for what merges pictures
      {"accel", record.options.accelerator.name},
      {"pixels", PixelsText(record)},
  };
  if (IsDenoisedByLibrary(record)) settings["denoised_by"] = record.denoised_by;
  if (record.options.keep_times) {
    settings["seconds"] = Fixed(record.seconds.wall, 3);
    settings["threads"] = std::to_string(record.threads);
  }
  if (const auto& view = record.options.render.view) settings["camera"] = CameraLine(*view);
  for (const std::string& setting : record.scene.settings)
    settings["scene_settings"] += (settings["scene_settings"].empty() ? "" : ", ") + setting;
  return settings;
}

std::string LimitsOfLight(const RunStats& record) { return BiasText(record, true); }

std::string FinalLine(const RunStats& record) {
  return Escaped(record.picture) + " " + std::to_string(record.width) + "x" + std::to_string(record.height) + " " +
         SppText(record) + " " + Fixed(record.seconds.wall, 2) + " s " + Fixed(MegaraysPerSecond(record), 1) +
         " Mrays/s" + (record.IsComplete() ? "" : " (stopped by " + record.stopped_by + ", " + PixelsText(record) + ")") +
         "\n";
}

std::string QualityLines(const RunStats& record) {
  const bool is_asked = record.options.render.budget.IsOpen() || record.options.render.denoise || record.true_error;
  if (!is_asked)
    return SamplesWhereNeighborsDiffer(record.options.render) && record.IsComplete() ? SavedText(record) : "";
  std::string text;
  if (record.error) {
    const ErrorEstimate& e = *record.error;
    text = std::string(record.two_streams ? "estimated error " : "estimated error at most ") +
           ErrorText(e.estimate, e.unit) + " (" + Rounded(100 * record.options.render.budget.confidence, 6) +
           "%: " + Rounded(e.low, 3) + " to " + Rounded(e.high, 3) + FreedomText(e) + ")";
    if (const auto& before = record.error_before_denoising)
      text += " denoised" + DenoiserText(record) + ", " + ErrorText(before->estimate, before->unit) + " before";
    if (record.true_error) text += ", true error " + ErrorText(*record.true_error, e.unit);
    text += "; ";
  } else if (record.true_error) {
    text = "true error " + ErrorText(*record.true_error, ErrorUnit::display) + "; ";
  }
  return text + "stopped by " + StopText(record) + " at " + Fixed(record.samples.mean, 1) + " samples per pixel" +
         ForecastText(record) + LimitsText(record) + "\n";
}

std::string Statistics(const RunStats& record) {
  const auto line = [](std::string name, const std::string& value) {
    constexpr std::size_t column_of_values = 18;
    name.resize(column_of_values, ' ');
    return "  " + name + value + "\n";
  };
  const auto count = [&](const char* name, auto number) { return line(name, std::to_string(number)); };
  const auto& [scene, rays, seconds] = std::tie(record.scene, record.rays, record.seconds);
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
         (record.guide_rays > 0 ? count("  for guides", record.guide_rays) : "") + "tests\n" +
         count("nodes", cost.node_visits) + count("boxes", cost.box_tests) + count("primitives", cost.primitive_tests) +
         count("hits", cost.hits) + count("last-hit lookups", cost.cache_tests) +
         count("last-hit hits", cost.cache_hits) + "tests per ray       nodes     boxes  primitives    hits\n" + costs +
         "time\n" + line("load", Seconds(seconds.load)) + line("build", Seconds(seconds.build)) +
         line("render", Seconds(seconds.render)) +
         (record.denoise_seconds > 0
              ? line("  denoise", Seconds(record.denoise_seconds)) + line("    guides", Seconds(record.guide_seconds))
              : "") +
         line("write", Seconds(seconds.write)) + line("wall", Seconds(seconds.wall)) +
         line("cpu", Seconds(seconds.cpu)) + "run\n" + count("threads", record.threads) +
         line("accelerator", record.accelerator + " (-accel " + record.options.accelerator.name + ")") +
         line("structure", Fixed(1e-6 * static_cast<double>(record.structure_bytes), 1) + " MB") +
         line("peak memory", Fixed(1e-6 * static_cast<double>(record.peak_memory), 1) + " MB") +
         line("pixels", std::to_string(record.pixels_done) + " of " + std::to_string(record.pixels_total)) +
         line("kernel", record.kernel) + "image\n" +
         line("samples", std::to_string(record.samples.least) + " to " + std::to_string(record.samples.most) +
                             " per pixel, mean " + Fixed(record.samples.mean, 2)) +
         ErrorLines(record, line) + line("bias from", Listed(record.biased) + DarknessText(record)) +
         line("stopped", record.stopped_by);
}

}  // namespace ray

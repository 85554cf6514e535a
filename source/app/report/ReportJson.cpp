#include "source/app/report/ReportJson.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "source/app/options/OptionTable.h"
#include "source/text/Number.h"

namespace ray {

std::span<const ReportField> ReportFields() {
  static constexpr ReportField fields[] = {
      {"version", "version of the program, such as \"0.1.0\""},
      {"command", "the command as typed"},
      {"scene", "file (as typed), hash (of all files it was read from), nodes, instances, primitives, lights"},
      {"settings",
       "every option in force by its name: numbers, true or false, names; crop is [x0, y0, x1, y1] or null, "
       "allow_path a list"},
      {"rays",
       "number of camera, shadow, reflection, transmission and diffuse rays; cut (wanted, but over the limit"
       " of a camera ray); caustics (paths that found the brightest light by way of mirrors or glass); total"
       " (all but cut); guides (rays of -denoise, which total includes); refining (most, and samples per "
       "pixel, of the guides' own camera rays; null without a time limit); costs (the counts of each kind)"},
      {"counts", "node_visits, box_tests, primitive_tests, hits, cache_tests, cache_hits, bad_rays"},
      {"accelerator", "the structure that was built; settings.accel is the requested one"},
      {"structure_bytes", "memory of the structure, besides the scene"},
      {"seconds",
       "load, build, render, denoise (a part of render), guides (a part of denoise), write, wall (from the "
       "start of the program to the report), cpu (of all threads)"},
      {"peak_memory_bytes", "the maximum memory of the process"},
      {"threads", "number of threads that rendered"},
      {"pixels", "done, total"},
      {"warnings", "lines printed to standard error"},
      {"stop",
       "reason (\"samples\", \"time\", \"error\", \"stall\", or a signal such as \"SIGINT\"), confidence, and "
       "the requested seconds and error (target, unit), or null"},
      {"features_required", "names of the features that scene and settings require"},
      {"kernel", "the innermost loops that ran"},
      {"quality", "the preset, or \"custom\""},
      {"biased", "settings in force that change the expected image"},
      {"share_cut", "estimated fraction of the light, 0 to 1, that -max_depth and -min_luminance cut off"},
      {"samples",
       "least, most and mean per pixel; two_streams; shared_light (see -share); planned_samples (what strata "
       "and camera rays are laid out for); of_blocks (per pixel and stream, of each block of 8x8 pixels in rows "
       "from the bottom; empty if all are equal); places_of_blocks (of blocks without samples, how many of their 64 "
       "places were traced; empty if all have samples)"},
      {"error",
       "estimate, low, high, unit; method (\"two streams\": unbiased; \"two streams, denoised\"; \"halves\":"
       " an upper bound); worst_block (error, at); freedom (degrees of freedom); outlier_share; unseen_share"
       " (fraction of the square of high that is for caustics no path has found); true_error where there is "
       "a reference; before_denoising and denoised_by where it was denoised; null below two samples"},
      {"passes",
       "for each pass: end (samples per pixel and stream), samples (mean per pixel), seconds (since the "
       "first ray), error (left by the filter with -denoise and -error; or null)"},
  };
  return fields;
}

namespace {

using Json = nlohmann::ordered_json;

/// A function object that returns the value of an option as JSON.
struct ValueIn {
  const RenderOptions& options;

  template <class Plain>
  Json operator()(const Plain& plain) const {
    return plain.member.read(options);
  }
  Json operator()(const OneNameOf& one) const { return one.read(options); }
  Json operator()(const Repeated& list) const {
    Json words = Json::array();
    for (const auto& word : list.member.read(options)) words.push_back(word);
    return words;
  }
  Json operator()(const Rectangle& rectangle) const {
    const auto& crop = rectangle.member.read(options);
    return crop ? Json{crop->x0, crop->y0, crop->x1, crop->y1} : Json();
  }
  Json operator()(const NumberList& list) const { return list.read(options); }
  Json operator()(const Word& word) const {
    const std::string shown = word.show(options);
    const auto [whole, problem] = ParseWhole(shown);
    return word.may_be_number && !problem ? Json(whole) : Json(shown);
  }
  Json operator()(const PixelRequest&) const { return {}; }
  Json operator()(const Request&) const { return {}; }
};

}  // namespace

nlohmann::ordered_json SettingsJson(const RunStats& stats) {
  const RenderOptions& options = stats.options;
  Json settings;
  for (const OptionKind& option : OptionTable(*options.program))
    if (IsSetting(option)) settings[option.name] = std::visit(ValueIn{options}, option.value);
  return settings;
}

namespace {

Json CostJson(const Counts& cost) {
  return {{"node_visits", cost.node_visits},
          {"box_tests", cost.box_tests},
          {"primitive_tests", cost.primitive_tests},
          {"hits", cost.hits},
          {"cache_tests", cost.cache_tests},
          {"cache_hits", cost.cache_hits},
          {"bad_rays", cost.bad_rays}};
}

Json Rays(const RayCounts& rays, std::uint64_t guides, const std::optional<Refinement>& refinement) {
  Json json, costs;
  for (std::size_t i = 0; i < ray_kind_names.size(); ++i) {
    json[ray_kind_names[i]] = rays.kinds[i].rays;
    costs[ray_kind_names[i]] = CostJson(rays.kinds[i].cost);
  }
  json["cut"] = rays.cut;
  json["caustics"] = rays.caustics;
  json["total"] = rays.Total();
  json["guides"] = guides;
  json["refining"] = refinement ? Json{{"most", refinement->rays}, {"samples", refinement->samples}} : Json();
  json["costs"] = costs;
  return json;
}

Json ErrorJson(const RunStats& stats) {
  if (!stats.error) return {};
  const ErrorEstimate& e = *stats.error;
  const PixelRectangle& w = e.worst_block_at;
  const auto& before = stats.error_before_denoising;
  Json json = {{"estimate", e.estimate},
               {"low", e.low},
               {"high", e.high},
               {"unit", ErrorUnitName(e.unit)},
               {"method", before              ? "two streams, denoised"
                          : stats.two_streams ? "two streams"
                                              : "halves"},
               {"worst_block", {{"error", e.worst_block}, {"at", {w.x0, w.y0, w.x1, w.y1}}}},
               {"freedom", e.freedom},
               {"outlier_share", e.outlier_share},
               {"unseen_share", e.unseen_share}};
  if (stats.true_error) json["true_error"] = *stats.true_error;
  if (before) {
    json["before_denoising"] = before->estimate;
    json["denoised_by"] = stats.denoised_by;
  }
  return json;
}

Json StopJson(const RunStats& stats) {
  const Budget& budget = stats.options.render.budget;
  Json json = {{"reason", stats.stopped_by}, {"confidence", budget.confidence}};
  json["seconds"] = budget.seconds > 0 ? Json(budget.seconds) : Json();
  json["error"] =
      budget.error ? Json{{"target", budget.error->value}, {"unit", ErrorUnitName(budget.error->unit)}} : Json();
  return json;
}

/// Returns the data for -replay: the number of samples of each block, or one number for all.
Json SamplesJson(const RunStats& stats) {
  Json json = {{"least", stats.samples.least},
               {"most", stats.samples.most},
               {"mean", stats.samples.mean},
               {"two_streams", stats.two_streams},
               {"shared_light", stats.shares_light},
               {"planned_samples", stats.planned_samples}};
  const auto& blocks = stats.block_samples;
  const bool are_alike = std::adjacent_find(blocks.begin(), blocks.end(), std::not_equal_to<>()) == blocks.end();
  json["of_blocks"] = are_alike ? Json::array() : Json(blocks);
  const auto& places = stats.block_places;
  const bool has_looks = std::ranges::any_of(places, [](std::uint8_t count) { return count > 0; });
  json["places_of_blocks"] = has_looks ? Json(places) : Json::array();
  return json;
}

Json SceneJson(const RunStats& stats) {
  const auto& scene = stats.scene;
  return {{"file", stats.options.files.scene},
          {"hash", scene.hash},
          {"nodes", scene.nodes},
          {"instances", scene.instances},
          {"primitives", scene.primitives},
          {"lights", scene.lights}};
}

Json SecondsJson(const RunStats& stats) {
  const auto& seconds = stats.seconds;
  return {{"load", seconds.load},          {"build", seconds.build},
          {"render", seconds.render},      {"denoise", stats.denoise_seconds},
          {"guides", stats.guide_seconds}, {"write", seconds.write},
          {"wall", seconds.wall},          {"cpu", seconds.cpu}};
}

Json Passes(const RunStats& stats) {
  Json passes = Json::array();
  for (const Pass& pass : stats.passes) {
    Json json = {{"end", pass.end}, {"samples", pass.samples}, {"seconds", pass.seconds}};
    json["error"] = pass.error ? Json(pass.error->estimate) : Json();
    passes.push_back(json);
  }
  return passes;
}

}  // namespace

std::string ReportJson(const RunStats& stats) {
  const Json report = {
      {"version", RAYPRO_VERSION},
      {"command", stats.command},
      {"scene", SceneJson(stats)},
      {"settings", SettingsJson(stats)},
      {"rays", Rays(stats.rays, stats.guide_rays, stats.refinement)},
      {"counts", CostJson(stats.rays.Cost())},
      {"accelerator", stats.accelerator},
      {"structure_bytes", stats.structure_bytes},
      {"seconds", SecondsJson(stats)},
      {"peak_memory_bytes", stats.peak_memory},
      {"threads", stats.threads},
      {"pixels", {{"done", stats.pixels_done}, {"total", stats.pixels_total}}},
      {"warnings", stats.warnings},
      {"stop", StopJson(stats)},
      {"features_required", stats.needs},
      {"kernel", stats.kernel},
      {"quality", stats.options.quality},
      {"biased", stats.biased},
      {"share_cut", stats.share_cut},
      {"samples", SamplesJson(stats)},
      {"error", ErrorJson(stats)},
      {"passes", Passes(stats)},
  };
  // File names are bytes and need not be UTF-8, which JSON must be.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ray

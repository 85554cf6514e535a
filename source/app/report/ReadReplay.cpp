#include "source/app/report/ReadReplay.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "source/app/Status.h"
#include "source/app/files/ReadInputs.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ReportJson.h"
#include "source/film/denoise/DenoiseFilters.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/parse/document/Document.h"

namespace ray {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t most_samples = 0x7fffffff;  // the maximum of -samples

SceneErrors Refusal(const std::string& file, const std::string& why) {
  return SceneErrors({ErrorIn(file, "cannot be replayed: " + why)});
}

/// Reads a report. The library traverses the result recursively, so a report may nest no deeper than a scene in JSON.
Json ReadReport(const std::string& file) {
  return Json::parse(Contents(file), [&](int depth, Json::parse_event_t event, const Json&) {
    const bool opens = event == Json::parse_event_t::array_start || event == Json::parse_event_t::object_start;
    if (opens && depth >= Document::max_depth)
      throw Refusal(file, "it is nested deeper than " + std::to_string(Document::max_depth) + " levels");
    return true;
  });
}

/// Returns a value for a message: file names may be any bytes, and an untrusted value may have any length.
std::string Shown(const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= most_quoted ? Escaped(text) : Quoted(text);
}

/// Returns true if the option must equal the report's value. The report determines the number of samples; a user who
/// also requests another number is mistaken.
bool MustAgree(const OptionKind& option, const RenderOptions& options) {
  return option.facts.Has(Fact::image) || (option.name == std::string("samples") && options.IsGiven("samples"));
}

void RequireSameSettings(const Json& settings, const RunStats& run) {
  const RenderOptions& options = run.options;
  const Json ours = SettingsJson(run);
  for (const OptionKind& option : OptionTable(*options.program)) {
    const std::string name = option.name;
    if (!MustAgree(option, options)) continue;
    const Json& then = settings.at(name);
    if (then != ours.at(name))
      throw UsageError("the report was made with -" + name + " " + Shown(then) + ", not " + Shown(ours.at(name)));
  }
}

bool IsDenoised(const Json& report) { return report.at("error").contains("denoised_by"); }

/// Requires the same version of the library, since another may produce other bits.
void RequireSameDenoiser(const Json& report, Denoiser denoiser) {
  if (!IsDenoised(report) || denoiser == Denoiser::regression) return;
  const Json& then = report.at("error").at("denoised_by");
  const std::string now = DenoiseFilters(denoiser).Name();
  if (then != now) throw UsageError("the report was made with " + Shown(then) + ", not " + Quoted(now));
}

/// Returns a count in a report, from 0 to `most`.
std::uint32_t Count(const Json& number, std::uint32_t most, const char* of_what, const std::string& file) {
  if (!number.is_number_unsigned() || number > most)
    throw Refusal(file, Shown(number) + " is not a number of " + of_what);
  return number.get<std::uint32_t>();
}

std::optional<Refinement> RefinementOf(const Json& report, const std::string& file) {
  const Json& refining = report.at("rays").at("refining");
  if (refining.is_null()) return {};
  if (!refining.at("most").is_number_unsigned())
    throw Refusal(file, Shown(refining.at("most")) + " is not a number of rays");
  return Refinement{refining.at("most"), Count(refining.at("samples"), most_samples, "samples", file)};
}

Replay SamplesOf(const Json& report, const std::string& file) {
  const auto samples = [&](const Json& number) { return Count(number, most_samples, "samples", file); };
  const Json& taken = report.at("samples");
  Replay replay;
  replay.two_streams = taken.at("two_streams");
  replay.shares_light = taken.at("shared_light");
  replay.planned_samples = samples(taken.at("planned_samples"));
  replay.looked_at_error = !report.at("stop").at("error").is_null();
  replay.denoised = IsDenoised(report);
  if (replay.denoised) replay.refinement = RefinementOf(report, file);
  for (const Json& pass : report.at("passes")) replay.ends.push_back(samples(pass.at("end")));
  for (const Json& of_block : taken.at("of_blocks")) replay.samples.push_back(samples(of_block));
  for (const Json& of_block : taken.at("places_of_blocks"))
    replay.places.push_back(static_cast<std::uint8_t>(Count(of_block, BlockOrder::places, "places of a block", file)));
  return replay;
}

void RequireSamplesOfAllBlocks(const Replay& replay, const std::string& file, const RenderSettings& render) {
  const auto refuse = [&](const std::string& why) { return Refusal(file, why); };
  if (replay.ends.empty()) throw refuse("it has no passes");
  const auto blocks = static_cast<std::size_t>(EmptyFilmOf(render).Blocks());
  for (const std::size_t size : {replay.samples.size(), replay.places.size()})
    if (size != 0 && size != blocks)
      throw refuse("it has " + std::to_string(size) + " blocks of pixels, the image " + std::to_string(blocks));
  const auto has_any = [](const auto& counts) { return std::ranges::any_of(counts, [](auto n) { return n > 0; }); };
  const bool has_samples = has_any(replay.ends) && (replay.samples.empty() || has_any(replay.samples));
  if (replay.planned_samples == 0 || !(has_samples || has_any(replay.places))) throw refuse("it has no samples");
}

}  // namespace

std::optional<Replay> ReadReplay(const RunStats& run) {
  const std::string& file = run.options.files.replay;
  if (file.empty()) return {};
  try {
    const Json report = ReadReport(file);
    if (report.at("scene").at("hash") != run.scene.hash) throw UsageError("the report belongs to a different scene");
    RequireSameSettings(report.at("settings"), run);
    RequireSameDenoiser(report, run.options.render.denoiser);
    Replay replay = SamplesOf(report, file);
    RenderSettings render = run.options.render;
    render.shares_light = replay.shares_light;
    RequireSamplesOfAllBlocks(replay, file, render);
    return replay;
  } catch (const Json::parse_error& error) {
    throw Refusal(file, "it is not JSON: syntax error at byte " + std::to_string(error.byte));
  } catch (const Json::exception&) {
    throw Refusal(file, "it is not a report that -report has written");
  }
}

}  // namespace ray

#include "source/app/report/ReadReplay.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "source/app/Status.h"
#include "source/app/files/ReadInputs.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ReportJson.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/parse/document/Document.h"
#include "source/render/Render.h"

namespace ray {
namespace {

/// How many blocks of samples the picture has.
std::size_t BlocksOf(const RenderSettings& render) { return static_cast<std::size_t>(EmptyFilmOf(render).Blocks()); }

using Json = nlohmann::ordered_json;

constexpr std::uint32_t most_samples = 0x7fffffff;  // what -samples takes

SceneErrors Refusal(const std::string& file, const std::string& why) {
  return SceneErrors({ErrorIn(file, "cannot be replayed: " + why)});
}

/// The library walks through what it has read by recursion, so a report may nest no deeper than a scene in JSON.
Json ReadReport(const std::string& file) {
  return Json::parse(Contents(file), [&](int depth, Json::parse_event_t event, const Json&) {
    const bool opens = event == Json::parse_event_t::array_start || event == Json::parse_event_t::object_start;
    if (opens && depth >= Document::max_depth)
      throw Refusal(file, "it is nested deeper than " + std::to_string(Document::max_depth) + " levels");
    return true;
  });
}

/// A value for a message: file names may be any bytes, and a stranger's value of any length.
std::string Shown(const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= most_quoted ? Escaped(text) : Quoted(text);
}

/// Options that say what a picture shows; those of speed may differ.
bool ChoosesThePicture(const OptionKind& option) {
  const std::string topic = option.topic;
  return IsSetting(option) && (topic == "picture" || topic == "light");
}

}  // namespace

std::optional<Replay> ReadReplay(const Options& options, const std::string& scene_hash) {
  if (options.replay.empty()) return {};
  const auto refuse = [&](const std::string& why) { return Refusal(options.replay, why); };
  try {
    const Json report = ReadReport(options.replay);
    if (report.at("scene").at("hash") != scene_hash) throw UsageError("the report is of another scene");
    const Json ours = SettingsJson(options);
    for (const OptionKind& option : OptionTable(options.program)) {
      const std::string name = option.name;
      if (!ChoosesThePicture(option) || name == "samples") continue;
      const Json& then = report.at("settings").at(name);
      if (then != ours.at(name))
        throw UsageError("the report was made with -" + name + " " + Shown(then) + ", not " + Shown(ours.at(name)));
    }
    const auto count = [&](const Json& number) {
      if (!number.is_number_unsigned() || number > most_samples)
        throw refuse(Shown(number) + " is not a number of samples");
      return number.get<std::uint32_t>();
    };
    Replay replay;
    replay.two_streams = report.at("samples").at("two_streams");
    replay.planned_samples = count(report.at("samples").at("planned_samples"));
    for (const Json& pass : report.at("passes")) replay.ends.push_back(count(pass.at("end")));
    for (const Json& of_block : report.at("samples").at("of_blocks")) replay.samples.push_back(count(of_block));
    for (const Json& of_block : report.at("samples").at("places_of_blocks")) {
      if (count(of_block) > BlockOrder::places) throw refuse(Shown(of_block) + " is not a number of places of a block");
      replay.places.push_back(of_block.get<std::uint8_t>());
    }
    if (!replay.places.empty() && replay.places.size() != BlocksOf(options.render))
      throw refuse("its places are not of as many blocks as the picture has");
    if (replay.ends.empty()) throw refuse("it has no passes");
    const auto are_all_zero = [](const auto& counts) { return std::ranges::count(counts, 0u) == std::ssize(counts); };
    if (replay.planned_samples == 0 || (are_all_zero(replay.ends) && are_all_zero(replay.places)) ||
        (!replay.samples.empty() && are_all_zero(replay.samples) && are_all_zero(replay.places)))
      throw refuse("it has no samples");
    if (!replay.samples.empty() && replay.samples.size() != BlocksOf(options.render))
      throw refuse("it has " + std::to_string(replay.samples.size()) + " blocks of pixels, the picture " +
                   std::to_string(BlocksOf(options.render)));
    return replay;
  } catch (const Json::exception& error) {
    throw refuse(Escaped(error.what()));
  }
}

}  // namespace ray

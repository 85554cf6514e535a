#include "source/app/report/ReadReplay.h"

#include <nlohmann/json.hpp>

#include "source/app/Status.h"
#include "source/app/files/ReadInputs.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ReportJson.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/render/Render.h"

namespace ray {
namespace {

/// How many blocks of samples the picture has.
std::size_t BlocksOf(const RenderSettings& render) { return static_cast<std::size_t>(EmptyFilmOf(render).Blocks()); }

using Json = nlohmann::ordered_json;

constexpr std::uint32_t most_samples = 0x7fffffff;  // what -samples takes

/// Options that say what a picture shows; those of speed may differ.
bool ChoosesThePicture(const OptionKind& option) {
  const std::string topic = option.topic;
  return IsSetting(option) && (topic == "picture" || topic == "light");
}

}  // namespace

std::optional<Replay> ReadReplay(const Options& options, const std::string& scene_hash) {
  if (options.replay.empty()) return {};
  const std::string text = Contents(options.replay);
  const auto refuse = [&](const std::string& why) -> SceneErrors {
    return SceneErrors({ErrorIn(options.replay, "cannot be replayed: " + why)});
  };
  try {
    const Json report = Json::parse(text);
    if (report.at("scene").at("hash") != scene_hash) throw UsageError("the report is of another scene");
    const Json ours = SettingsJson(options);
    for (const OptionKind& option : OptionTable(options.program)) {
      const std::string name = option.name;
      if (!ChoosesThePicture(option) || name == "samples") continue;
      const Json& then = report.at("settings").at(name);
      if (then != ours.at(name))
        throw UsageError("the report was made with -" + name + " " + then.dump() + ", not " + ours.at(name).dump());
    }
    const auto count = [&](const Json& number) {
      if (!number.is_number_unsigned() || number > most_samples)
        throw refuse(number.dump() + " is not a number of samples");
      return number.get<std::uint32_t>();
    };
    Replay replay;
    replay.two_streams = report.at("samples").at("two_streams");
    replay.planned_samples = count(report.at("samples").at("planned_samples"));
    for (const Json& pass : report.at("passes")) replay.ends.push_back(count(pass.at("end")));
    for (const Json& of_block : report.at("samples").at("of_blocks")) replay.samples.push_back(count(of_block));
    for (const Json& of_block : report.at("samples").at("places_of_blocks")) {
      if (count(of_block) > BlockOrder::places) throw refuse(of_block.dump() + " is not a number of places of a block");
      replay.places.push_back(of_block.get<std::uint8_t>());
    }
    if (!replay.places.empty() && replay.places.size() != BlocksOf(options.render))
      throw refuse("its places are not of as many blocks as the picture has");
    if (replay.ends.empty()) throw refuse("it has no passes");
    if (!replay.samples.empty() && replay.samples.size() != BlocksOf(options.render))
      throw refuse("it has " + std::to_string(replay.samples.size()) + " blocks of pixels, the picture " +
                   std::to_string(BlocksOf(options.render)));
    return replay;
  } catch (const Json::exception& error) {
    throw refuse(Escaped(error.what()));
  }
}

}  // namespace ray

#include "source/app/ReportJson.h"

#include <nlohmann/json.hpp>

#include "source/app/OptionTable.h"

namespace ray {
namespace {

using Json = nlohmann::ordered_json;

/// The value of an option, as JSON.
struct ValueIn {
  const Options& options;

  template <class Plain>
  Json operator()(const Plain& plain) const {
    return plain.member.read(options);
  }
  Json operator()(const FolderList& list) const {
    Json folders = Json::array();
    for (const auto& folder : list.member.read(options)) folders.push_back(folder.string());
    return folders;
  }
  Json operator()(const Rectangle& rectangle) const {
    const auto& crop = rectangle.member.read(options);
    return crop ? Json{crop->x0, crop->y0, crop->x1, crop->y1} : Json();
  }
  Json operator()(const Request&) const { return {}; }
};

Json Settings(const Options& options) {
  Json settings;
  for (const OptionKind& option : OptionTable())
    if (IsSetting(option)) settings[option.name] = std::visit(ValueIn{options}, option.value);
  return settings;
}

Json CostJson(const Counts& cost) {
  return {{"node_visits", cost.node_visits}, {"box_tests", cost.box_tests},     {"primitive_tests", cost.primitive_tests},
          {"hits", cost.hits},               {"cache_tests", cost.cache_tests}, {"cache_hits", cost.cache_hits},
          {"bad_rays", cost.bad_rays}};
}

Json Rays(const RayCounts& rays) {
  Json json, costs;
  for (std::size_t i = 0; i < ray_kind_names.size(); ++i) {
    json[ray_kind_names[i]] = rays.kinds[i].rays;
    costs[ray_kind_names[i]] = CostJson(rays.kinds[i].cost);
  }
  json["cut"] = rays.cut;
  json["total"] = rays.Total();
  json["costs"] = costs;
  return json;
}

}  // namespace

std::string ReportJson(const Record& record) {
  const auto& [scene, rays, seconds] = std::tie(record.scene, record.rays, record.seconds);
  const Json report = {
      {"version", RAYPRO_VERSION},
      {"command", record.command},
      {"scene",
       {{"file", record.options.scene},
        {"hash", scene.hash},
        {"nodes", scene.nodes},
        {"instances", scene.instances},
        {"primitives", scene.primitives},
        {"lights", scene.lights}}},
      {"settings", Settings(record.options)},
      {"rays", Rays(rays)},
      {"counts", CostJson(rays.Cost())},
      {"structure_bytes", record.structure_bytes},
      {"seconds",
       {{"load", seconds.load},
        {"build", seconds.build},
        {"render", seconds.render},
        {"write", seconds.write},
        {"wall", seconds.wall},
        {"cpu", seconds.cpu}}},
      {"peak_memory_bytes", record.peak_memory},
      {"threads", record.threads},
      {"pixels", {{"done", record.pixels_done}, {"total", record.pixels_total}}},
      {"warnings", record.warnings},
      {"stop", record.stop},
  };
  // File names are bytes and need not be UTF-8, which JSON must be.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ray

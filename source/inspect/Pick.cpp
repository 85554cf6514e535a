#include "source/inspect/Pick.h"

#include <algorithm>
#include <array>

#include "source/inspect/SceneLines.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr int digits = 7;

std::string Shortly(double number) { return Rounded(number, digits); }
std::string Shortly(double x, double y, double z) { return Shortly(x) + " " + Shortly(y) + " " + Shortly(z); }
std::string Shortly(const R2::Color& c) { return Shortly(c.r, c.g, c.b); }

std::string LocationOf(const Node& node, const Scene& scene) {
  if (node.location.line == 0) return "(built in)";
  return scene.files[node.location.file] + ":" + std::to_string(node.location.line);
}

/// The groups above a node, the nearest first.
std::vector<const Node*> GroupsAbove(const World& world, std::uint32_t instance) {
  const auto& nodes = world.Nodes();
  const auto own = std::ranges::find(nodes, static_cast<std::int32_t>(instance), &FlatNode::instance);
  std::vector<const Node*> above;
  if (own == nodes.end()) return above;
  const std::vector<std::size_t> parents = ParentsOf(world);
  for (auto i = parents[static_cast<std::size_t>(own - nodes.begin())]; i != nodes.size(); i = parents[i])
    above.push_back(nodes[i].node);
  return above;
}

std::string RaysOf(const PixelTrace& trace) {
  std::array<int, ray_kind_names.size()> counts{};
  for (const RecordedRay& ray : trace.rays) ++counts[static_cast<std::size_t>(ray.kind)];
  std::string text = "rays " + std::to_string(trace.rays.size());
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k] > 0) text += ", " + std::string(ray_kind_names[k]) + " " + std::to_string(counts[k]);
  return text;
}

}  // namespace

Pick PickPixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column,
               int row) {
  Pick pick{PixelTracer(world, accelerator, settings).Trace(column, row, 1), {}, 0, {}};
  pick.text.push_back("pixel " + std::to_string(column) + " " + std::to_string(row) + ": " +
                      Shortly(pick.trace.Mean()));
  if (pick.trace.rays.empty()) {
    pick.text.emplace_back("is outside of what the camera sees");
    return pick;
  }
  const RecordedRay& ray = pick.trace.rays.front();
  if (!ray.hit) {
    pick.text.emplace_back("hits nothing");
    return pick;
  }
  pick.point = ray.at->position;
  pick.instance = ray.hit->instance;
  const Instance& instance = world.Instances()[pick.instance];
  const Scene& scene = world.scene();
  std::string path = LocationOf(*instance.node, scene);
  for (const Node* group : GroupsAbove(world, pick.instance))
    if (group->location.line > 0) path += " < " + LocationOf(*group, scene);
  const R3::SurfacePoint& at = *ray.at;
  const Material& m = *instance.material;
  pick.text.push_back("node " + path);
  pick.text.push_back("primitive " + std::to_string(world.PrimitiveId(*ray.hit)) + ", t " + Shortly(ray.hit->t) +
                      ", distance " + Shortly(ray.hit->t * Length(ray.ray.direction)));
  pick.text.push_back("at " + Shortly(at.position.x, at.position.y, at.position.z));
  pick.text.push_back("normal " + Shortly(at.normal.x, at.normal.y, at.normal.z) + ", uv " + Shortly(at.uv.x) + " " +
                      Shortly(at.uv.y));
  pick.text.push_back("ka " + Shortly(m.ka) + ", kd " + Shortly(m.kd) + ", ks " + Shortly(m.ks) + ", kt " +
                      Shortly(m.kt));
  pick.text.push_back("emission " + Shortly(m.emission) + ", n " + Shortly(m.n) + ", ir " + Shortly(m.ir) +
                      (m.texture ? ", texture" : "") + (m.bump ? ", bump" : "") + (m.normal_map ? ", normal map" : "") +
                      (m.specular_map ? ", specular map" : "") + (m.gloss > 0 ? ", gloss " + Shortly(m.gloss) : ""));
  pick.text.push_back(RaysOf(pick.trace));
  return pick;
}

}  // namespace ray

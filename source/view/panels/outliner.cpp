#include <imgui.h>

#include "source/text/Words.h"
#include "source/view/commands/Commands.h"
#include "source/view/panels/Panel.h"
#include "source/view/panels/Tree.h"

// The scene graph, the lights, and what the chosen one of them is.
namespace ray {
namespace {

constexpr int outliner_lines = 14;

std::string NodeName(const FlatNode& flat) {
  const Node& node = *flat.node;
  std::string name = "group of " + std::to_string(flat.children);
  if (node.line) name = "line";
  if (node.operation) {
    name = "csg";
  } else if (node.shape) {
    const auto recipe = node.shape->MadeFrom();
    const int elements = node.shape->Elements();
    name = recipe ? recipe->kind : "mesh of " + Counted(static_cast<std::uint64_t>(elements), "triangle");
  }
  return name + (node.location.line > 0 ? ", line " + std::to_string(node.location.line) : "");
}

void DrawMaterial(PanelFrame& frame, const Material& m) {
  const auto color = [&](const char* name, const R2::Color& c) {
    if (!(c == R2::Color{})) frame.Fact(name, Brief(c));
  };
  color("ka", m.ka);
  color("kd", m.kd);
  color("ks", m.ks);
  if (!(m.kr == m.ks)) color("kr", m.kr);
  color("kt", m.kt);
  color("emission", m.emission);
  color("absorb", m.absorb);
  frame.Fact("n", Brief(m.n));
  if (m.ir != 1) frame.Fact("ir", Brief(m.ir));
  if (m.coat > 0) frame.Fact("coat", Brief(m.coat));
  if (m.texture) frame.Fact("texture", m.texture->file);
  if (m.texture_scale != R2::Vector{1, 1})
    frame.Fact("texture_scale", Brief(m.texture_scale.x) + " " + Brief(m.texture_scale.y));
  if (m.projects_textures) frame.Fact("texture_project", "yes");
  if (m.one_sided) frame.Fact("one_sided", "yes");
  if (m.gloss > 0) frame.Fact("gloss", Brief(m.gloss));
  if (m.specular_map) frame.Fact("specular_map", m.specular_map->file);
  if (m.normal_map) frame.Fact("normal_map", m.normal_map->file);
  if (m.bump) frame.Fact("bump", m.bump->file + " " + Brief(m.bump_height));
}

class Outliner : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const LoadedScene& scene = frame.viewer.scene.Loaded();
    if (std::exchange(scene_number_, frame.viewer.scene.Number()) != frame.viewer.scene.Number()) {
      nodes_.Forget();
      nodes_.SetOpen(0, true);
      parents_ = ParentsOf(scene.world);
    }
    const auto chosen = frame.viewer.selection.node;
    if (chosen && chosen != last_chosen_)
      for (std::size_t up = parents_[*chosen]; up != parents_.size(); up = parents_[up]) nodes_.SetOpen(up, true);
    last_chosen_ = chosen;
    DrawNodes(frame, scene.world);
    if (chosen) DrawNode(frame, scene.world.Nodes()[*chosen]);
    DrawLights(frame, scene.parsed.scene);
  }

 private:
  void DrawNodes(PanelFrame& frame, const World& world) {
    const auto children_of = [&](std::size_t node) {
      std::vector<std::size_t> children;
      const FlatNode& flat = world.Nodes()[node];
      for (std::uint32_t c = 0; c < flat.children; ++c) children.push_back(flat.first_child + c);
      return children;
    };
    const auto text_of = [&](std::size_t node) {
      if (node != 0) return NodeName(world.Nodes()[node]);
      return "scene, " + Counted(static_cast<std::uint64_t>(world.Primitives()), "primitive");
    };
    const auto clicked =
        nodes_.Draw(frame, "nodes", {{0}, children_of, text_of}, outliner_lines, frame.viewer.selection.node);
    if (clicked) frame.Ask([node = *clicked](ViewerState& v) { ChooseNode(v, node); });
  }

  static void DrawNode(PanelFrame& frame, const FlatNode& flat) {
    ImGui::Separator();
    const Node& node = *flat.node;
    const Scene& scene = frame.viewer.scene.Parsed();
    if (node.location.line > 0)
      frame.Fact("from", scene.files[node.location.file] + ":" + std::to_string(node.location.line));
    if (node.shape) {
      if (const auto recipe = node.shape->MadeFrom()) {
        std::string numbers;
        for (const double number : recipe->arguments) numbers += (numbers.empty() ? "" : " ") + Brief(number);
        frame.Fact(recipe->kind, numbers);
      }
    }
    if (!node.bounds.IsEmpty()) {
      frame.Fact("low", Brief(node.bounds.low));
      frame.Fact("high", Brief(node.bounds.high));
    }
    if (flat.instance >= 0)
      DrawMaterial(frame, *frame.viewer.scene.world().Instances()[static_cast<std::size_t>(flat.instance)].material);
    if (frame.Button("frame")) frame.Ask([](ViewerState& v) { FrameChosenNode(v); });
    ImGui::SameLine();
    if (frame.Button("deselect")) frame.Ask([](ViewerState& v) { ChooseNode(v, {}); });
  }

  static void DrawLights(PanelFrame& frame, const Scene& scene) {
    ImGui::Separator();
    const std::size_t count = scene.lights.size();
    frame.Say(std::to_string(count) + (count == 1 ? " light" : " lights") +
              (scene.has_default_lights ? ", the default ones" : ""));
    constexpr std::size_t most_lights = 50;  // that a reader goes through
    for (std::size_t i = 0; i < std::min(count, most_lights); ++i) frame.Say("- " + Brief(scene.lights[i]->Describe()));
    if (count > most_lights) frame.Say("and " + std::to_string(count - most_lights) + " more");
    if (!(scene.ambient == R2::Color{})) frame.Fact("ambient", Brief(scene.ambient));
    frame.Fact("sky", Brief(scene.background));
  }

  int scene_number_ = 0;  // as Viewer counts, from 1
  Tree nodes_;
  std::vector<std::size_t> parents_;
  std::optional<std::size_t> last_chosen_;
};

}  // namespace

extern const PanelPart outliner_part{"outline", [] { return std::unique_ptr<Panel>(new Outliner); }};

}  // namespace ray

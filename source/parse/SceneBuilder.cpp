#include "source/parse/SceneBuilder.h"

#include <cassert>
#include <utility>

#include "source/parse/CsgOf.h"

namespace ray {

std::vector<Node> SceneBuilder::NodesOf(const std::shared_ptr<const Assets::Model>& model, int material) {
  const auto [known, is_new] = first_materials.try_emplace(model, static_cast<int>(scene.materials.size()));
  if (is_new) scene.materials.insert(scene.materials.end(), model->materials.begin(), model->materials.end());
  std::vector<Node> nodes_of_parts;
  for (const Assets::Model::Part& part : model->parts) {
    Node& node = nodes_of_parts.emplace_back();
    node.shape = part.mesh.mesh;
    node.bounds = part.mesh.bounds;
    node.material = part.material ? known->second + static_cast<int>(*part.material) : material;
  }
  return nodes_of_parts;
}

void SceneBuilder::Add(Node node) {
  ++nodes;
  open_groups.back().children.push_back(std::move(node));
}

void SceneBuilder::OpenGroup(Node group) {
  ++nodes;
  if (group.operation) ++open_operations;
  open_groups.push_back(std::move(group));
}

void SceneBuilder::CloseGroup() {
  assert(open_groups.size() > 1);
  Node group = std::move(open_groups.back());
  open_groups.pop_back();
  if (group.operation && --open_operations == 0) group.shape = CsgOf(group);
  SetBounds(group);
  open_groups.back().children.push_back(std::move(group));
}

const Material& SceneBuilder::MaterialOf(int material) const {
  for (std::size_t i = open_groups.size(); material == Node::inherit && i-- > 0;) material = open_groups[i].material;
  constexpr int default_material = 0;
  return scene.materials[static_cast<std::size_t>(material == Node::inherit ? default_material : material)];
}

std::optional<CsgFault> SceneBuilder::FaultOfCsg(const Node& node) {
  constexpr std::size_t most_operations = 1000;  // a ray walks from the innermost to the outermost
  if (node.operation && open_operations >= most_operations)
    return CsgFault{"csg is nested deeper than 1000 levels", "a union takes any number of solids"};
  if (!IsBlack(MaterialOf(node.material).emission))
    return CsgFault{"solids of a csg cannot emit light, but this material does", "emission of 0 0 0 does not"};
  if (MaterialOf(node.material).has_vertex_colors)
    return CsgFault{"solids of a csg cannot have vertex colors, but this material uses them",
                    "a material without vertex_colors"};
  if (node.line) return CsgFault{"csg combines solids, but this is a line", ""};
  if (!node.shape) return {};
  const auto* mesh = dynamic_cast<const R3::Mesh*>(node.shape.get());
  if (!mesh) {
    if (node.shape->IsBounded() && node.shape->IsSolid()) return {};
    return CsgFault{"csg combines closed solids, but this shape is not closed", "a thin box has an inside"};
  }
  const auto [known, is_new] = is_closed.try_emplace(mesh, false);
  if (is_new) known->second = mesh->IsClosed();
  if (known->second) return {};
  return CsgFault{"csg combines closed solids, but this mesh is open or inside out",
                  "every edge needs two triangles, their fronts outward"};
}

Scene SceneBuilder::Finish() {
  assert(open_groups.size() == 1);
  scene.root = std::move(open_groups.front());
  SetBounds(scene.root);
  scene.has_default_camera = !has_camera;
  scene.has_default_lights = !has_light;
  if (!has_camera) {
    const Camera named = scene.camera;
    scene.camera = DefaultCamera(scene.root.bounds);
    scene.camera.TakeViewOf(named);
  }
  if (!has_light) scene.lights = DefaultLights();
  return std::move(scene);
}

}  // namespace ray

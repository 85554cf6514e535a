#include "source/parse/SceneBuilder.h"

#include <cassert>
#include <utility>

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
  open_groups.push_back(std::move(group));
}

void SceneBuilder::CloseGroup() {
  assert(open_groups.size() > 1);
  Node group = std::move(open_groups.back());
  open_groups.pop_back();
  SetBounds(group);
  open_groups.back().children.push_back(std::move(group));
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

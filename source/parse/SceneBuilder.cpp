#include "source/parse/SceneBuilder.h"

#include <cassert>
#include <utility>

namespace ray {

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

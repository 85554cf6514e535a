#pragma once

#include <map>
#include <memory>
#include <vector>

#include "source/parse/Assets.h"
#include "source/scene/Scene.h"

namespace ray {

/// A scene while it is read, with the groups that are still open. Groups are kept on a stack, so that nesting costs
/// memory but no stack frames.
struct SceneBuilder {
  Scene scene;
  std::vector<Node> open_groups{1};  // the root first, the innermost last
  std::size_t nodes = 0;
  bool has_camera = false;
  std::map<std::shared_ptr<const Assets::Model>, int> first_materials;  // of models, in scene.materials
  bool has_light = false;  // a light of any kind was named, even one that stays out for a mistake

  /// The parts of a model as nodes, to be added one by one; those without a material of their own have this one. Its
  /// materials are added to the scene when it is first used.
  std::vector<Node> NodesOf(const std::shared_ptr<const Assets::Model>& model, int material);
  /// Into the innermost open group. The node's bounds must be set.
  void Add(Node node);
  void OpenGroup(Node group);
  /// The innermost group, not the root, becomes a child of the one around it.
  void CloseGroup();
  /// Fills in the default camera and lights where none was named. Every group must be closed.
  Scene Finish();
};

}  // namespace ray

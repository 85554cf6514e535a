#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "R3/Mesh.h"
#include "source/parse/Assets.h"
#include "source/scene/Scene.h"

namespace ray {

/// Why something cannot be a part of an operation on solids.
struct CsgFault {
  const char *message, *hint;
};

/// A scene while it is read, with the groups that are still open. Groups are kept on a stack, so that nesting costs
/// memory but no stack frames.
struct SceneBuilder {
  Scene scene;
  std::vector<Node> open_groups{1};  // the root first, the innermost last
  std::size_t nodes = 0;
  bool has_camera = false;
  std::map<std::shared_ptr<const Assets::Model>, int> first_materials;  // of models, in scene.materials
  std::size_t open_operations = 0;                                      // of open_groups
  std::map<const R3::Mesh*, bool> are_closed;                           // meshes of operations
  bool has_light = false;  // a light of any kind was named, even one that stays out for a mistake

  /// The parts of a model as nodes, to be added one by one; those without a material of their own have this one. Its
  /// materials are added to the scene when it is first used.
  std::vector<Node> NodesOf(const std::shared_ptr<const Assets::Model>& model, int material);
  /// Into the innermost open group. The node's bounds must be set.
  void Add(Node node);
  void OpenGroup(Node group);
  /// The innermost group, not the root, becomes a child of the one around it. One that is an operation not within
  /// another gets the shape that it makes.
  void CloseGroup();

  /// Whether what is added now is part of an operation on solids.
  bool IsInCsg() const { return open_operations > 0; }
  /// Nothing for a node that can be a part of one, or an operation itself.
  std::optional<CsgFault> FaultOfCsg(const Node& node);
  /// The one that a node with this material would have if it were added now.
  const Material& MaterialOf(int material) const;
  /// Fills in the default camera and lights where none was named. Every group must be closed.
  Scene Finish();
};

}  // namespace ray

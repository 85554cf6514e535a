#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "R3/Mesh.h"
#include "source/parse/Assets.h"
#include "source/scene/Scene.h"

namespace ray {

/// The reason that something cannot be a part of an operation on solids.
struct CsgFault {
  const char *message, *hint;
};

/// A scene under construction, with the groups that are still open. Groups are kept on a stack, so that nesting takes
/// memory but no stack frames.
struct SceneBuilder {
  Scene scene;
  std::vector<Node> open_groups{1};  // the root first, the innermost last
  std::size_t nodes = 0;
  bool has_camera = false;
  std::map<std::shared_ptr<const Assets::Model>, int> first_materials;  // per model, an index into scene.materials
  std::size_t open_operations = 0;                                      // number of open_groups with an operation
  std::map<const R3::Mesh*, bool> is_closed;                            // meshes of operations
  bool has_light = false;  // a light of any kind was named, even one skipped because of a mistake

  /// Returns the parts of a model as nodes, to be added one at a time; parts without a material get the given one. Adds
  /// the model's materials to the scene on first use.
  std::vector<Node> NodesOf(const std::shared_ptr<const Assets::Model>& model, int material);
  /// Adds a node to the innermost open group. The node's bounds must be set.
  void Add(Node node);
  void OpenGroup(Node group);
  /// Closes the innermost group, which is not the root, and adds it to its parent. An outermost operation gets its
  /// combined shape.
  void CloseGroup();

  /// Returns true if nodes added now are part of an operation on solids.
  bool IsInCsg() const { return open_operations > 0; }
  /// Returns why a node cannot be a part of an operation, or an operation itself; std::nullopt if it can.
  std::optional<CsgFault> FaultOfCsg(const Node& node);
  /// Returns the material that a node with this material would have if it were added now.
  const Material& MaterialOf(int material) const;
  /// Completes the scene with default camera and lights if none was named. Every group must be closed.
  Scene Finish();
};

}  // namespace ray

#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "R3/Mesh.h"
#include "R3/Transform.h"
#include "source/scene/Scene.h"

namespace ray {

/// A shape placed in the world.
struct Instance {
  static constexpr std::int32_t not_shared = -1;

  const R3::Shape* shape = nullptr;  // the node's, or what it was made into; of one side where its material is
  const R3::Mesh* mesh = nullptr;    // the same, if it is one, with both sides
  R3::Form form = R3::Form::other;   // of the shape's elements
  bool is_bounded = true;            // the shape lies in a box
  bool is_repeated = false;          // another is the same to the bit and hides this one, which is never the hit
  std::uint32_t repeats = 0;         // which instance that is
  R3::Box bounds{};                  // in the world, wherever it goes while the shutter is open; empty if not bounded
  double error = 0;                  // more than eight times as much as its surface may be off by in the world
  bool is_medium = false;            // its inside matters to rays: a closed solid that is clear or absorbs
  bool has_parts = false;            // of materials of their own
  bool has_clear_parts = false;      // through which light goes
  const Material* material = nullptr;
  const Node* node = nullptr;
  std::uint32_t frame = 0;           // index into World::frames; 0 when baked
  std::int32_t shared = not_shared;  // index into World::SharedMeshes
  std::int64_t first_primitive = 0;  // its elements are the primitives first_primitive, first_primitive + 1, ...

  /// Whether light goes through its surface.
  bool IsClear() const { return has_clear_parts || !IsBlack(material->kt); }
  /// The mesh whose triangles its elements are to rays; null for other shapes, and where the mesh has one side.
  const R3::Mesh* TwoSidedMesh() const { return material->one_sided ? nullptr : mesh; }
  /// Whether its surface is ever seen to shine.
  bool Emits() const { return !is_repeated && !IsBlack(material->emission); }
  /// From where on a ray may meet the element: its t_min, or later where it starts on the element, or never.
  double BeginOf(const R3::Ray& ray, int element) const {
    const std::int64_t primitive = first_primitive + element;
    if (primitive == ray.leaving) return ray.leaving_until;
    return primitive == ray.reaching ? R3::infinity : ray.t_min;
  }
};

/// A crossing of a ray with one element of one instance.
struct WorldHit : R3::Hit {
  std::uint32_t instance = 0;
  int element = 0;
  bool is_contested = false;  // others were found so near to it that they may be coincident
};

/// A node of the scene graph in one array, parents before children, the children of a node side by side.
struct FlatNode {
  const Node* node = nullptr;
  std::uint32_t frame = 0;                      // of the children; of the node itself where it has a shape
  std::uint32_t first_child = 0, children = 0;  // skipped subtrees have none
  std::int32_t instance = -1;                   // of a node with a shape
};

/// The scene flattened: every shape with the one transform that places it. A mesh used once is baked: its corners are
/// moved into the world, so that rays need not be moved to it. A mesh used several times is shared and stays where it
/// is. All accelerators see the same elements in the same frames. Looks into the scene, which must outlive it.
class World {
 public:
  explicit World(const Scene& scene);
  World(const World&) = delete;

  const Scene& scene() const { return scene_; }
  /// All instances in the order of the scene file, which is the order of primitive ids.
  const std::vector<Instance>& Instances() const { return instances_; }
  /// Indices of the instances that lie in no box: accelerators ask them beside their structure.
  const std::vector<std::uint32_t>& Unbounded() const { return unbounded_; }
  /// All nodes, the root first.
  const std::vector<FlatNode>& Nodes() const { return nodes_; }
  /// world_from_local of the groups; a group without a transform of its own shares its parent's. 0 is the world itself.
  const std::vector<R3::Transform>& Frames() const { return frames_; }
  std::int64_t Primitives() const { return primitives_; }
  /// Whether any group moves while the shutter is open.
  bool Moves() const { return moves_; }
  /// How far the shapes of a frame go while the shutter is open, in the world.
  const R3::Vector& MotionOf(std::uint32_t frame) const { return motions_[frame]; }
  /// A ray seen from a frame at the ray's time.
  R3::Ray Back(std::uint32_t frame, const R3::Ray& ray) const {
    if (frame == 0) return ray;
    if (!moves_) return frames_[frame].Back(ray);
    R3::Ray then = ray;
    then.origin = ray.origin - ray.time * motions_[frame];
    return frames_[frame].Back(then);
  }
  /// A box in a frame, in the world, wherever it goes while the shutter is open.
  R3::Box InWorld(std::uint32_t frame, const R3::Box& box) const {
    return Along(frames_[frame] * box, motions_[frame]);
  }
  /// A place of a frame's surface, in the world at a time. Its error also covers the rounding of seeing the point from
  /// the frame again, so a ray that starts outside it starts outside the shape.
  void BringToWorld(std::uint32_t frame, double time, R3::Intersection& at) const;
  /// The least distance up to which hits that are coincident, but for errors, are looked for.
  double CoincidenceWindow() const { return coincidence_window_; }
  /// The meshes that several instances use, in the order of their first use.
  const std::vector<const R3::Mesh*>& SharedMeshes() const { return shared_meshes_; }
  /// Lines for the scene's author: groups left out because all transforms above them together cannot be inverted.
  const std::vector<std::string>& Warnings() const { return warnings_; }

  const Instance& InstanceOf(std::int64_t primitive) const {
    return *std::prev(std::ranges::upper_bound(instances_, primitive, {}, &Instance::first_primitive));
  }
  std::int64_t PrimitiveId(const WorldHit& hit) const { return instances_[hit.instance].first_primitive + hit.element; }
  const Material& MaterialAt(const WorldHit& hit) const {
    const Instance& instance = instances_[hit.instance];
    return instance.has_parts ? MaterialOfPart(instance, hit) : *instance.material;
  }
  bool Emits(const WorldHit& hit) const { return !IsBlack(MaterialAt(hit).emission); }
  /// All that the instance shows: its own, and those of parts.
  std::vector<const Material*> MaterialsOf(const Instance& instance) const;

  /// The surface at a hit of `ray`, in world coordinates, as BringToWorld brings it there.
  R3::Intersection At(const R3::Ray& ray, const WorldHit& hit) const;
  /// How texture coordinates run over the surface there, with tangents in the world.
  R3::UvTangents UvTangentsAt(const R3::Ray& ray, const WorldHit& hit) const;

 private:
  struct GroupTransform;
  void FlattenGraph();
  /// Composes a group's transform with a node's own, as a new frame where it differs. False if nothing of the node can
  /// be hit, since its transform is singular.
  bool Enter(const Node& node, GroupTransform& group);
  void NumberInstances();
  void ProjectTextures();
  void BakeOrShareMeshes();
  void TakeBacksAway();
  void MarkParts();
  void MarkMedia();
  const Material& MaterialOfPart(const Instance& instance, const R3::Hit& hit) const;
  void BoundInstances();
  static void Shift(const R3::Vector& way, R3::Intersection& at);

  const Scene& scene_;
  std::vector<FlatNode> nodes_;
  std::vector<Instance> instances_;
  std::vector<std::uint32_t> unbounded_;
  std::vector<R3::Transform> frames_;
  std::vector<R3::Vector> motions_;  // of frames_
  bool moves_ = false;
  double coincidence_window_ = 0;
  std::vector<const R3::Mesh*> shared_meshes_;
  std::vector<std::unique_ptr<const R3::Mesh>> projected_meshes_, baked_meshes_;
  std::vector<std::unique_ptr<const R3::Shape>> one_sided_shapes_;
  std::int64_t primitives_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace ray

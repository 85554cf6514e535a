#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "R3/Mesh.h"
#include "R3/Transform.h"
#include "source/scene/Scene.h"

namespace ray {

/// A shape placed in the world.
struct Instance {
  static constexpr std::int32_t not_shared = -1;

  const R3::Shape* shape = nullptr;  // the node's, or a version of it; one-sided if its material is
  const R3::Mesh* mesh = nullptr;    // the same, if it is a mesh, with both sides
  R3::Form form = R3::Form::other;   // of the shape's elements
  bool is_bounded = true;            // the shape fits in a box
  bool is_repeated = false;          // bit-identical to another instance that hides it; it is never hit
  std::uint32_t repeats = 0;         // the index of that instance
  R3::Box bounds{};                  // in the world, over its motion during the shutter interval; empty if not bounded
  double error = 0;                  // more than eight times the error of its surface in the world
  bool is_medium = false;            // its inside matters to rays: a closed solid that is clear or absorbs
  bool has_parts = false;            // parts have separate materials
  bool has_clear_parts = false;      // some parts transmit light
  const Material* material = nullptr;
  const Node* node = nullptr;
  std::uint32_t frame = 0;           // index into World::frames; 0 when baked
  std::int32_t shared = not_shared;  // index into World::SharedMeshes
  std::int64_t first_primitive = 0;  // its elements are the primitives first_primitive, first_primitive + 1, ...

  /// Returns true if its surface transmits light.
  bool IsClear() const { return has_clear_parts || !IsBlack(material->kt); }
  /// Returns the mesh whose triangles its elements are for rays; null for other shapes, and if the mesh is one-sided.
  const R3::Mesh* TwoSidedMesh() const { return material->one_sided ? nullptr : mesh; }
  /// Returns true if its surface is ever visible as a light source.
  bool Emits() const { return !is_repeated && !IsBlack(material->emission); }
  /// Returns the t from which a ray may meet the element: its t_min, or later if it starts on the element, or infinity.
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
  bool is_contested = false;  // other hits are so near that they may be coincident
};

/// A node of the scene graph in one array, with parents before children and the children of a node contiguous.
struct FlatNode {
  const Node* node = nullptr;
  std::uint32_t frame = 0;                      // of the children; of the node itself if it has a shape
  std::uint32_t first_child = 0, children = 0;  // skipped subtrees have none
  std::int32_t instance = -1;                   // of a node with a shape
};

/// The scene flattened: every shape with the one transform that places it. A mesh used once is baked: its corners are
/// transformed to the world, so that rays need no transformation. A mesh used several times is shared and stays in its
/// frame. All accelerators see the same elements in the same frames. Refers to the scene, which must outlive it.
class World {
 public:
  explicit World(const Scene& scene);
  World(const World&) = delete;

  const Scene& scene() const { return scene_; }
  /// Returns all instances in the order of the scene file, which is the order of primitive ids.
  const std::vector<Instance>& Instances() const { return instances_; }
  /// Returns the indices of the unbounded instances, which accelerators test separately from their structure.
  const std::vector<std::uint32_t>& Unbounded() const { return unbounded_; }
  /// Returns all nodes, the root first.
  const std::vector<FlatNode>& Nodes() const { return nodes_; }
  /// Returns world_from_local of the groups; a group without its own transform shares its parent's. 0 is the world
  /// itself.
  const std::vector<R3::Transform>& Frames() const { return frames_; }
  std::int64_t Primitives() const { return primitives_; }
  /// Returns true if any group moves during the shutter interval.
  bool Moves() const { return moves_; }
  /// Returns the displacement of a frame's shapes in the world during the shutter interval.
  const R3::Vector& MotionOf(std::uint32_t frame) const { return motions_[frame]; }
  /// Transforms a ray into a frame at the ray's time.
  R3::Ray Back(std::uint32_t frame, const R3::Ray& ray) const {
    if (frame == 0) return ray;
    if (!moves_) return frames_[frame].Back(ray);
    R3::Ray then = ray;
    then.origin = ray.origin - ray.time * motions_[frame];
    return frames_[frame].Back(then);
  }
  /// Returns the box in the world around a box in a frame, over its motion during the shutter interval.
  R3::Box InWorld(std::uint32_t frame, const R3::Box& box) const {
    return Along(frames_[frame] * box, motions_[frame]);
  }
  /// Transforms an intersection from a frame to the world at a time. Its error also covers the rounding of mapping the
  /// point back to the frame, so a ray that starts outside of it starts outside the shape.
  void BringToWorld(std::uint32_t frame, double time, R3::Intersection& at) const;
  /// Returns the minimum distance within which coincident hits are searched.
  double CoincidenceWindow() const { return coincidence_window_; }
  /// Returns the meshes that several instances use, in the order of their first use.
  const std::vector<const R3::Mesh*>& SharedMeshes() const { return shared_meshes_; }
  /// Returns warnings for the scene's author about groups that were skipped because their combined transform is
  /// singular.
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
  /// Returns all materials of the instance: its own, and those of its parts.
  std::vector<const Material*> MaterialsOf(const Instance& instance) const;

  /// Returns the surface at a hit of `ray`, in world coordinates, as by BringToWorld.
  R3::Intersection At(const R3::Ray& ray, const WorldHit& hit) const;
  /// Returns the change of texture coordinates over the surface there, with tangents in the world.
  R3::UvTangents UvTangentsAt(const R3::Ray& ray, const WorldHit& hit) const;

 private:
  struct GroupTransform;
  void FlattenGraph();
  /// Composes a group's transform with a node's own, as a new frame if it differs. Returns false if the transform is
  /// singular, so that nothing of the node can be hit.
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
  std::vector<R3::Vector> motions_;  // one per frame
  bool moves_ = false;
  double coincidence_window_ = 0;
  std::vector<const R3::Mesh*> shared_meshes_;
  std::vector<std::unique_ptr<const R3::Mesh>> projected_meshes_, baked_meshes_;
  std::vector<std::unique_ptr<const R3::Shape>> one_sided_shapes_;
  std::int64_t primitives_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace ray

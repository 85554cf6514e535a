#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "R3/Transform.h"
#include "source/accelerate/Counts.h"
#include "source/scene/Scene.h"

namespace ray {

/// A shape placed in the world.
struct Instance {
  const R3::Shape* shape = nullptr;
  const Material* material = nullptr;
  const Node* node = nullptr;
  std::uint32_t frame = 0;            // index into World::frames
  std::int64_t first_primitive = 0;   // its elements are the primitives first_primitive, first_primitive + 1, ...
};

/// A crossing of a ray with one element of one instance.
struct WorldHit {
  R3::Hit hit;
  std::uint32_t instance = 0;
  int element = 0;
};

/// The scene flattened: every shape with the one transform that places it. Looks into the scene, which must outlive it.
class World {
 public:
  explicit World(const Scene& scene);

  const Scene& GetScene() const { return scene_; }
  const std::vector<Instance>& Instances() const { return instances_; }
  /// world_from_local of each group that holds shapes; shapes of one group share a frame. Frame 0 is the world's own.
  const std::vector<R3::Transform>& Frames() const { return frames_; }
  std::int64_t Primitives() const { return primitives_; }
  /// Lines for the scene's author: subtrees left out because their transform is singular.
  const std::vector<std::string>& Warnings() const { return warnings_; }

  R3::Ray LocalRay(std::uint32_t frame, const R3::Ray& ray) const { return frames_[frame].Back(ray); }

  std::int64_t PrimitiveId(const WorldHit& hit) const { return instances_[hit.instance].first_primitive + hit.element; }
  const Material& MaterialAt(const WorldHit& hit) const { return *instances_[hit.instance].material; }

  /// The surface at a hit of `ray`, in world coordinates. Its error also covers the rounding of seeing the point from
  /// the shape's own frame again, so a ray that starts outside it starts outside the shape.
  R3::Intersection At(const R3::Ray& ray, const WorldHit& hit) const;

 private:
  friend class GraphAccelerator;
  const Scene& scene_;
  std::vector<Instance> instances_;
  std::vector<R3::Transform> frames_;
  std::int64_t primitives_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace ray

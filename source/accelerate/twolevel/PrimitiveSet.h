#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "R3/Box.h"
#include "source/accelerate/World.h"

namespace ray {

/// The target of a leaf of a structure: an element of an instance, or a whole shared mesh with its own structure.
struct PrimRef {
  static constexpr std::int32_t whole = -1;

  std::uint32_t instance = 0;
  std::int32_t element = whole;
};

/// A sphere with all data that its test needs, stored in line with the traversal's memory.
struct alignas(32) SphereLeaf {
  R3::SphereData sphere;
  std::int64_t primitive = 0;  // in the world's numbering
  std::uint32_t instance = 0;
};

/// A tighter bound of a primitive than its Bounds.
struct Hull {
  R3::Box box;  // in its own frame
  R3::Profile profile;
  const R3::Matrix* local_from_world;
  double padding;  // of hits in the world, without the part that grows with the distance of ray origins
};

/// The primitives of one structure: the world, or the inside of one shared mesh in that mesh's own frame. They are
/// numbered from 0 in the order of their primitive ids.
class PrimitiveSet {
 public:
  /// Makes the set of the world, in which each shared mesh is one primitive; all other shapes contribute their
  /// elements.
  explicit PrimitiveSet(const World& world);
  /// Makes the set of the inside of world.SharedMeshes()[number]. The instance of its primitives is the one being
  /// traversed.
  PrimitiveSet(const World& world, int number);

  std::uint32_t Size() const { return size_; }
  PrimRef operator[](std::uint32_t i) const {
    const Run& run = RunOf(i);
    return {run.instance, run.is_whole ? PrimRef::whole : static_cast<std::int32_t>(i - run.first)};
  }

  /// Returns a box around every hit of the primitive by rays whose origin is the world's; rays from farther away find
  /// hits up to PaddingPerDistance * (largest component of their origin in the world) outside. Finite.
  R3::Box Bounds(std::uint32_t i) const;
  double PaddingPerDistance() const { return padding_per_distance_; }

  /// Returns the hull of a primitive of the world.
  Hull HullOf(std::uint32_t i) const;

  /// Returns the mesh of a triangle in the set's own frame, which batches of triangle tests can process; null for other
  /// primitives.
  const R3::Mesh* MeshOf(std::uint32_t i) const;
  /// Returns the sphere if the primitive is one in the set's own frame.
  std::optional<SphereLeaf> SphereOf(std::uint32_t i) const;

  std::size_t Bytes() const { return runs_.size() * sizeof(Run) + run_of_.size() * sizeof(std::uint32_t); }

 private:
  /// Consecutive primitives of one instance.
  struct Run {
    std::uint32_t first = 0, instance = 0;
    bool is_whole = false;
  };
  void Add(std::uint32_t instance, bool is_whole, std::uint32_t count);
  const Run& RunOf(std::uint32_t i) const {
    if (runs_.size() == 1) return runs_[0];
    if (!run_of_.empty()) return runs_[run_of_[i]];
    return *(std::upper_bound(runs_.begin(), runs_.end(), i,
                              [](std::uint32_t primitive, const Run& run) { return primitive < run.first; }) -
             1);
  }

  const World& world_;
  const R3::Mesh* mesh_ = nullptr;  // the mesh of which this is the inside
  std::vector<Run> runs_;
  std::vector<std::uint32_t> run_of_;  // only if runs are so short that searching would take longer
  std::uint32_t size_ = 0;
  double padding_per_distance_ = 0;
};

}  // namespace ray

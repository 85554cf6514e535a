#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "R3/Box.h"
#include "source/accelerate/World.h"

namespace ray {

/// What a leaf of a structure refers to: an element of an instance, or a whole shared mesh with a structure of its own.
struct PrimRef {
  static constexpr std::int32_t whole = -1;

  std::uint32_t instance = 0;
  std::int32_t element = whole;
};

/// A sphere with all that its test needs, to be copied to where traversal comes by.
struct alignas(32) SphereLeaf {
  R3::SphereData sphere;
  std::int64_t primitive = 0;  // as the world numbers them
  std::uint32_t instance = 0;
};

/// Where a primitive is, more closely than by its Bounds.
struct Hull {
  R3::Box box;  // of its own frame
  R3::Profile profile;
  const R3::Matrix* local_from_world;
  double padding;  // in the world: by how much hits may lie outside, besides what grows with the distance of origins
};

/// What one structure is built over: the world, or the inside of one shared mesh in that mesh's own frame. Its
/// primitives are numbered from 0 in the order of their primitive ids.
class PrimitiveSet {
 public:
  /// The world: each shared mesh is one primitive, everything else is there element by element.
  explicit PrimitiveSet(const World& world);
  /// The inside of world.SharedMeshes()[number]. The instance of its primitives is whichever is being looked into.
  PrimitiveSet(const World& world, int number);

  std::uint32_t Size() const { return size_; }
  PrimRef operator[](std::uint32_t i) const {
    const Run& run = RunOf(i);
    return {run.instance, run.is_whole ? PrimRef::whole : static_cast<std::int32_t>(i - run.first)};
  }

  /// A box around every hit of the primitive by rays whose origin is the world's; a ray from farther away finds hits up
  /// to PaddingPerDistance * (largest component of its origin in the world) outside. Finite.
  R3::Box Bounds(std::uint32_t i) const;
  double PaddingPerDistance() const { return padding_per_distance_; }

  /// The hull of a primitive of the world.
  Hull HullOf(std::uint32_t i) const;

  /// The mesh whose triangle the primitive is, if that lies in the set's own frame: what batches of triangle tests
  /// can work on. Null for others.
  const R3::Mesh* MeshOf(std::uint32_t i) const;
  /// The sphere that the primitive is, if it is one in the set's own frame.
  std::optional<SphereLeaf> SphereOf(std::uint32_t i) const;

  std::size_t Bytes() const { return runs_.size() * sizeof(Run) + run_of_.size() * sizeof(std::uint32_t); }

 private:
  /// Primitives of one instance in a row.
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
  const R3::Mesh* mesh_ = nullptr;  // of which this is the inside
  std::vector<Run> runs_;
  std::vector<std::uint32_t> run_of_;  // only where runs are so short that searching would take longer
  std::uint32_t size_ = 0;
  double padding_per_distance_ = 0;
};

}  // namespace ray

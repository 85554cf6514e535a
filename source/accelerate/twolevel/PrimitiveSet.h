#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "R3/Box.h"
#include "source/accelerate/World.h"

namespace ray {

/// What a structure finds in one place: an element of an instance, or a whole shared mesh with a structure of its own.
struct PrimRef {
  static constexpr std::int32_t whole = -1;

  std::uint32_t instance = 0;
  std::int32_t element = whole;
};

/// A room that one structure divides: the world, or the inside of one shared mesh in that mesh's own frame. Its items
/// are numbered from 0 in the order of their primitive ids.
class PrimitiveSet {
 public:
  /// The world: each shared mesh is one item, everything else is there element by element.
  explicit PrimitiveSet(const World& world);
  /// The inside of world.SharedMeshes()[number]. The instance of its items is whichever is being looked into.
  PrimitiveSet(const World& world, int number);

  std::uint32_t Items() const { return items_; }
  PrimRef operator[](std::uint32_t i) const {
    const Run& run = RunOf(i);
    return {run.instance, run.is_whole ? PrimRef::whole : static_cast<std::int32_t>(i - run.first_item)};
  }

  /// A box around every hit of the item by rays whose origin is the world's; a ray from farther away finds hits up to
  /// PadPerDistance * (largest component of its origin in the world) outside. Finite.
  R3::Box Bounds(std::uint32_t i) const;
  double PadPerDistance() const { return pad_per_distance_; }

  /// The mesh whose triangle the item is, if that lies in the space's own frame: what batches of triangle tests can
  /// work on. Null for others.
  const R3::Mesh* MeshOf(std::uint32_t i) const;

  std::size_t Bytes() const { return runs_.size() * sizeof(Run) + run_of_item_.size() * sizeof(std::uint32_t); }

 private:
  /// Items of one instance in a row.
  struct Run {
    std::uint32_t first_item = 0, instance = 0;
    bool is_whole = false;
  };
  void Add(std::uint32_t instance, bool is_whole, std::uint32_t count);
  const Run& RunOf(std::uint32_t i) const {
    if (runs_.size() == 1) return runs_[0];
    if (!run_of_item_.empty()) return runs_[run_of_item_[i]];
    return *(std::upper_bound(runs_.begin(), runs_.end(), i,
                              [](std::uint32_t item, const Run& run) { return item < run.first_item; }) -
             1);
  }

  const World& world_;
  const R3::Mesh* mesh_ = nullptr;  // of which this is the inside
  std::vector<Run> runs_;
  std::vector<std::uint32_t> run_of_item_;  // only where runs are so short that searching would take longer
  std::uint32_t items_ = 0;
  double pad_per_distance_ = 0;
};

}  // namespace ray

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "source/accelerate/HugeArray.h"
#include "source/accelerate/twolevel/TwoLevel.h"
#include "source/text/Words.h"

/// The data of the wide tree of boxes (as in Embree's BVH8). Everything in it is in single precision and only culls: it
/// decides which tests to skip, never which primitive is hit.
namespace ray::wide {

inline constexpr std::size_t unit = 32;  // bytes; the unit of memory

/// The kind and position of a child, in 32 bits: its first unit in Tree::memory, or the number of a single primitive.
/// Values from `nothing` on are no child.
struct Child {
  enum class Kind : std::uint32_t { node, triangles, sphere, hulls, primitive };
  static constexpr int kind_shift = 29;
  static constexpr std::uint32_t nothing = std::uint32_t{7} << kind_shift;

  static constexpr std::uint32_t Make(Kind kind, std::uint32_t index) {
    return static_cast<std::uint32_t>(kind) << kind_shift | index;
  }
  static Kind KindOf(std::uint32_t child) { return static_cast<Kind>(child >> kind_shift); }
  static bool IsNothing(std::uint32_t child) { return child >= nothing; }
  static std::uint32_t Index(std::uint32_t child) { return child & ((std::uint32_t{1} << kind_shift) - 1); }
};

/// Eight boxes in lanes. Plane 2 axis contains the low sides, plane 2 axis + 1 the high ones, rounded to the nearest
/// float; the padding of the ray covers that. Missing children have inside-out boxes.
struct alignas(unit) Node {
  float planes[6 * width];  // one array: rays store the index of their near planes
  float& At(int plane, int i) { return planes[plane * width + i]; }
  float At(int plane, int i) const { return planes[plane * width + i]; }
  std::uint32_t child[width];
};

/// The maximum number of levels of nodes, which Flatten checks. A node pushes at most `width` - 1 children, so a stack
/// of most_depth * width always suffices.
inline constexpr int most_depth = 64;

/// One structure over one set of primitives.
struct Tree {
  static constexpr bool meets_primitives_again = false;

  explicit Tree(PrimitiveSet the_primitives) : primitives(std::move(the_primitives)) {}

  PrimitiveSet primitives;
  Coordinates coordinates;
  /// Nodes, each followed by the blocks and spheres that are its children, depth-first: children visited together are
  /// stored together.
  struct alignas(unit) Unit {
    std::byte bytes[unit];
  };
  HugeArray<Unit> memory;
  std::size_t nodes = 0, blocks = 0;
  std::uint32_t root = Child::nothing;
  bool is_large = false;  // larger than a core's private cache: prefetching children pays
  int depth = 0;

  template <typename T>
  const T& At(std::uint32_t child) const {
    return *reinterpret_cast<const T*>(memory.Data() + Child::Index(child));
  }
  std::string Explain() const {
    return Counted(static_cast<std::uint64_t>(nodes), "node") + " in " +
           Counted(static_cast<std::uint64_t>(depth), "level") + ", " +
           Counted(static_cast<std::uint64_t>(blocks), "block") + " of triangles";
  }
  /// Returns the number of levels of boxes: the root's, then those of its children, and so on.
  int BoxLevels() const { return Child::IsNothing(root) ? 0 : depth + 1; }
  /// Returns the boxes in the frame of the primitives, rounded to single precision as in the traversal.
  std::vector<R3::Box> BoxesAt(int level) const;
  std::size_t Bytes() const { return memory.Bytes() + primitives.Bytes(); }
};

}  // namespace ray::wide

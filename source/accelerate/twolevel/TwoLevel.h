#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/NearestHit.h"
#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/accelerate/twolevel/PrimitiveSet.h"
#include "source/text/Words.h"

/// Common parts of structures that test eight triangles at a time.
namespace ray {

inline constexpr int width = 8;  // triangles per block, children per wide node

/// The range of scales: above these, and below their inverses, products of doubles leave their range, and certainty in
/// a structure's coordinates does not imply certainty in the scene's.
inline constexpr double most_scale = 0x1p200, most_per_t = 0x1p700;

/// The coordinates in which a structure computes in single precision: (p - center) * scale, so that all its boxes lie
/// in [-1, 1] and floats resolve them equally well wherever and however large the scene is. The scale is a power of
/// two.
struct Coordinates {
  R3::Point center;
  double scale = 1;
  double largest_per_t = most_per_t;  // distance of a ray in these coordinates per t; 0 if the scale is out of range

  R3::Vector operator()(const R3::Point& p) const { return scale * (p - center); }
  R3::Point Back(const R3::Vector& v) const { return center + v / scale; }
};
Coordinates FitCoordinates(const PrimitiveSet& primitives);

/// Up to eight triangles in lanes. Missing ones have NaN corners, which no test accepts.
struct alignas(32) TriangleBlock {
  float corner[3][width], edge1[3][width], edge2[3][width];  // corner 0, corner 1 - corner 0, corner 2 - corner 0
  std::uint32_t primitive[width];
  std::uint32_t positions[3]
                         [width];  // numbers of the corners in the mesh, so that the exact test need not wait for them
};
/// Fills the block with `count` of the primitives, all of them triangles in the set's own frame.
void FillBlock(TriangleBlock& block, const PrimitiveSet& primitives, const Coordinates& coordinates,
               const std::uint32_t* triangles, int count);

/// Instancing: one structure over the world, and one over the inside of each shared mesh. A Structure has the members
///     PrimitiveSet primitives; Coordinates coordinates; std::size_t Bytes() const; std::string Explain() const;
///     int BoxLevels() const; std::vector<R3::Box> BoxesAt(int level) const;
///     static constexpr bool meets_primitives_again;  // a ray often meets the same primitive twice in a row
template <typename Structure>
struct TwoLevel {
  const World* world = nullptr;
  std::vector<Structure> structures;  // the world's first, then that of shared mesh i at i + 1
};

/// The traversal functions, compiled once per instruction set; all find the same hits.
template <typename Structure>
struct Kernels {
  std::int64_t instruction_set;  // in Highway's numbering
  void (*nearest)(const TwoLevel<Structure>& two_level, const R3::Ray& ray, NearestHit& nearest, Counts& counts);
  bool (*any)(const TwoLevel<Structure>& two_level, const R3::Ray& ray, Counts& counts);
  /// Packet versions for coherent rays; null if rays are traversed one at a time anyway.
  void (*nearest_packets)(const TwoLevel<Structure>& two_level, std::span<const R3::Ray> rays,
                          std::optional<WorldHit>* hits, Counts& counts) = nullptr;
  void (*any_packets)(const TwoLevel<Structure>& two_level, std::span<const R3::Ray> rays, bool* is_occluded,
                      Counts& counts) = nullptr;
};

/// An accelerator with such structures. `choose`, as described above, stores a Kernels<Structure>.
template <typename Structure>
class TwoLevelAccelerator : public Accelerator {
 public:
  template <typename Build>
  TwoLevelAccelerator(const World& world, const AcceleratorSettings& settings, void (*choose)(void*),
                      const Build& build)
      : Accelerator(world) {
    WithInstructionSet(settings.instruction_set, choose, &kernels_);
    two_level_.world = &world;
    two_level_.structures.push_back(build(PrimitiveSet(world)));
    for (int i = 0; i < static_cast<int>(world.SharedMeshes().size()); ++i)
      two_level_.structures.push_back(build(PrimitiveSet(world, i)));
  }

  std::size_t Bytes() const override {
    std::size_t sum = 0;
    for (const Structure& structure : two_level_.structures) sum += structure.Bytes();
    return sum;
  }

  int BoxLevels() const override { return two_level_.structures[0].BoxLevels(); }
  std::vector<R3::Box> BoxesAt(int level) const override { return two_level_.structures[0].BoxesAt(level); }

  std::vector<std::string> Explain() const override {
    std::vector<std::string> lines{"instruction set " + InstructionSetName(kernels_.instruction_set)};
    for (std::size_t i = 0; i < two_level_.structures.size(); ++i) {
      const Structure& structure = two_level_.structures[i];
      lines.push_back((i == 0 ? std::string("the world") : "shared mesh " + std::to_string(i)) + ": " +
                      Counted(structure.primitives.Size(), "primitive") + ", " + structure.Explain() + ", " +
                      std::to_string(structure.Bytes()) + " bytes");
    }
    return lines;
  }

 private:
  void Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const override {
    kernels_.nearest(two_level_, ray, nearest, workspace.counts);
  }

  bool Any(const R3::Ray& ray, Workspace& workspace) const override {
    return kernels_.any(two_level_, ray, workspace.counts);
  }

  void NearestBatch(std::span<const R3::Ray> rays, std::optional<WorldHit>* hits,
                     Workspace& workspace) const override {
    if (kernels_.nearest_packets)
      kernels_.nearest_packets(two_level_, rays, hits, workspace.counts);
    else
      Accelerator::NearestBatch(rays, hits, workspace);
  }

  void AnyBatch(std::span<const R3::Ray> rays, bool* is_occluded, Workspace& workspace) const override {
    if (kernels_.any_packets)
      kernels_.any_packets(two_level_, rays, is_occluded, workspace.counts);
    else
      Accelerator::AnyBatch(rays, is_occluded, workspace);
  }

  Kernels<Structure> kernels_{};
  TwoLevel<Structure> two_level_;
};

}  // namespace ray

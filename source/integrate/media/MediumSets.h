#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "R2/Color.h"
#include "source/accelerate/World.h"

namespace ray {

/// The optical properties of a place.
struct Medium {
  const Material* material = nullptr;  // determines the index of refraction; null in empty space
  R2::Color absorb;                    // per unit of length

  double Index() const { return material ? material->ir : 1; }
};

/// The sets of solids that paths are inside of: sets of a world's instances, identified by numbers, so that a path
/// carries only a number. 0 is the empty set, n + 1 the set of instance n alone; other sets are numbered as they occur.
/// Every thread has its own.
///   source   Schmidt and Budge, Simple nested dielectrics in ray traced images (2002), for priorities
class MediumSets {
 public:
  using Number = std::uint32_t;

  /// Forgets sets of two and more instances.
  void Clear() {
    if (!sets_.empty()) sets_.clear(), numbers_.clear();
  }

  /// Returns true if a set contains no instance other than this one.
  static bool IsWithin(Number set, std::uint32_t instance) { return set == 0 || set == instance + 1; }
  bool Has(Number set, std::uint32_t instance, const World& world) const;
  Number With(Number set, std::uint32_t instance, const World& world);
  Number Without(Number set, std::uint32_t instance, const World& world);
  /// Returns the medium inside all solids of a set. Of the materials with the highest priority, that of the first
  /// instance refracts, and each absorbs once, regardless of the number of solids made of it.
  Medium At(Number set, const World& world) const;

 private:
  using Instances = std::vector<std::uint32_t>;  // ascending
  struct Set {
    Instances instances;
    Medium medium;
  };
  Instances InstancesOf(Number set, const World& world) const;
  Number NumberOf(Instances instances, const World& world);
  static Number FirstOfMany(const World& world) { return static_cast<Number>(world.Instances().size()) + 1; }

  std::vector<Set> sets_;
  std::map<Instances, Number> numbers_;
};

}  // namespace ray

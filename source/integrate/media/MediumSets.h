#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "R2/Color.h"
#include "source/accelerate/World.h"

namespace ray {

/// What fills a place, as rays feel it.
struct Medium {
  const Material* material = nullptr;  // whose index of refraction counts; null where there is nothing
  R2::Color absorb;                    // per unit of length

  double Index() const { return material ? material->ir : 1; }
};

/// The solids that paths are inside of: sets of a world's instances, by number, so that a path carries a number alone.
/// 0 is the empty set, n + 1 that of instance n alone; other sets get numbers as they are met. Every thread has its
/// own.
///   source   Schmidt and Budge, Simple nested dielectrics in ray traced images (2002), for priorities
class MediumSets {
 public:
  using Number = std::uint32_t;

  /// Forgets sets of two and more.
  void Clear() {
    if (!sets_.empty()) sets_.clear(), numbers_.clear();
  }

  /// Whether a set holds nothing but perhaps the instance.
  static bool IsWithin(Number set, std::uint32_t instance) { return set == 0 || set == instance + 1; }
  bool Has(Number set, std::uint32_t instance, const World& world) const;
  Number With(Number set, std::uint32_t instance, const World& world);
  Number Without(Number set, std::uint32_t instance, const World& world);
  /// What fills a place inside all of a set: of the materials with the highest priority, the one of the first instance
  /// refracts, and each absorbs, once however many solids are made of it.
  Medium At(Number set, const World& world) const;

 private:
  using Instances = std::vector<std::uint32_t>;  // rising
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

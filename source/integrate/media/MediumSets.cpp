#include "source/integrate/media/MediumSets.h"

#include <algorithm>

namespace ray {
namespace {

Medium MediumOf(const std::vector<std::uint32_t>& instances, const World& world) {
  std::vector<const Material*> materials;  // of the highest priority, each once
  for (const std::uint32_t i : instances) {
    const Material* material = world.Instances()[i].material;
    if (!materials.empty() && material->priority < materials[0]->priority) continue;
    if (!materials.empty() && material->priority > materials[0]->priority) materials.clear();
    if (std::ranges::find(materials, material) == materials.end()) materials.push_back(material);
  }
  Medium medium{.material = materials[0], .absorb = {}};
  for (const Material* material : materials) medium.absorb += material->absorb;
  return medium;
}

}  // namespace

bool MediumSets::Has(Number set, std::uint32_t instance, const World& world) const {
  if (IsWithin(set, instance)) return set != 0;
  return set >= FirstOfMany(world) && std::ranges::binary_search(sets_[set - FirstOfMany(world)].instances, instance);
}

MediumSets::Number MediumSets::With(Number set, std::uint32_t instance, const World& world) {
  if (IsWithin(set, instance)) return instance + 1;
  Instances instances = InstancesOf(set, world);
  const auto at = std::ranges::lower_bound(instances, instance);
  if (at == instances.end() || *at != instance) instances.insert(at, instance);
  return NumberOf(std::move(instances), world);
}

MediumSets::Number MediumSets::Without(Number set, std::uint32_t instance, const World& world) {
  if (IsWithin(set, instance)) return 0;
  Instances instances = InstancesOf(set, world);
  std::erase(instances, instance);
  return NumberOf(std::move(instances), world);
}

Medium MediumSets::At(Number set, const World& world) const {
  if (set == 0) return {};
  if (set >= FirstOfMany(world)) return sets_[set - FirstOfMany(world)].medium;
  const Material* material = world.Instances()[set - 1].material;
  return {material, material->absorb};
}

MediumSets::Instances MediumSets::InstancesOf(Number set, const World& world) const {
  if (set == 0) return {};
  if (set < FirstOfMany(world)) return {set - 1};
  return sets_[set - FirstOfMany(world)].instances;
}

MediumSets::Number MediumSets::NumberOf(Instances instances, const World& world) {
  if (instances.size() < 2) return instances.empty() ? 0 : instances[0] + 1;
  const auto [found, is_new] =
      numbers_.try_emplace(std::move(instances), FirstOfMany(world) + static_cast<Number>(sets_.size()));
  if (is_new) sets_.push_back({found->first, MediumOf(found->first, world)});
  return found->second;
}

}  // namespace ray

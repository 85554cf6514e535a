#include "source/accelerate/Repetitions.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <typeinfo>
#include <vector>

#include "source/text/Hash.h"

namespace ray {
namespace {

bool AreSame(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)  // -0 differs from 0: operations on it may differ
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

bool AreSame(const R3::Matrix& a, const R3::Matrix& b) {
  for (std::size_t row = 0; row < a.m.size(); ++row)
    if (!AreSame(a.m[row], b.m[row])) return false;
  return true;
}

bool AreSame(const R3::Shape& a, const R3::Shape& b) {
  if (&a == &b) return true;
  const auto made = a.MadeFrom(), other = b.MadeFrom();
  return made && other && made->kind == other->kind && made->text == other->text &&
         AreSame(made->arguments, other->arguments);
}

/// Hashes the kind of shape, its box in its own frame, and the frame: enough to distinguish most shapes without
/// computing the recipe of every one in a large scene.
std::uint64_t HashOf(const Instance& instance, std::span<const R3::Transform> frames) {
  const R3::Shape& shape = *instance.shape;
  Hash hash;
  const auto add = [&](double number) { hash.AddWord(std::bit_cast<std::uint64_t>(number)); };
  hash.AddWord(typeid(shape).hash_code());
  const R3::Box& box = instance.node->bounds;
  for (const R3::Point& corner : {box.low, box.high})
    for (int axis = 0; axis < 3; ++axis) add(corner[axis]);
  if (instance.frame == 0) return hash.Value();  // the world's frame
  for (const auto& row : frames[instance.frame].Forward().m)
    for (const double entry : row) add(entry);
  return hash.Value();
}

/// An instance and its hash, in the order in which equal instances hide each other; see Contact.h.
struct Hashed {
  std::uint64_t hash;
  bool is_dark;
  std::uint32_t instance;

  auto operator<=>(const Hashed&) const = default;
};

}  // namespace

void MarkRepetitions(std::span<Instance> instances, std::span<const R3::Transform> frames,
                     std::span<const R3::Vector> motions) {
  const auto is_same_frame = [&](std::uint32_t a, std::uint32_t b) {
    return a == b || (AreSame(frames[a].Forward(), frames[b].Forward()) &&
                      AreSame(frames[a].Inverse(), frames[b].Inverse()) && motions[a] == motions[b]);
  };
  std::vector<Hashed> hashed;
  hashed.reserve(instances.size());
  for (std::uint32_t i = 0; i < instances.size(); ++i)
    if (!instances[i].mesh || instances[i].shared != Instance::not_shared)  // otherwise no other instance has it
      hashed.push_back({HashOf(instances[i], frames), IsBlack(instances[i].material->emission), i});
  std::sort(hashed.begin(), hashed.end());
  for (std::size_t first = 0, i = 1; i < hashed.size(); ++i) {
    if (hashed[i].hash != hashed[first].hash) {
      first = i;
      continue;
    }
    const Instance& seen = instances[hashed[first].instance];
    Instance& instance = instances[hashed[i].instance];
    instance.is_repeated = is_same_frame(seen.frame, instance.frame) && AreSame(*seen.shape, *instance.shape);
    instance.repeats = hashed[first].instance;
  }
}

}  // namespace ray

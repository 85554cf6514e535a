#include "source/accelerate/twolevel/PrimitiveSet.h"

#include <algorithm>
#include <stdexcept>

#include "source/accelerate/BoundsPadding.h"

namespace ray {
namespace {

// Structures use three bits of a number themselves.
constexpr std::uint32_t most_primitives = std::uint32_t{1} << 29;

/// Pads the box, and clips it so that sums of two coordinates stay in range: there are no hits beyond that.
R3::Box Widened(const R3::Box& box, double padding) {
  constexpr double far = 0x1p1020;
  const auto low = [&](double x) { return x - padding > -far ? std::min(x - padding, far) : -far; };  // also of NaN
  const auto high = [&](double x) { return x + padding < far ? std::max(x + padding, -far) : far; };
  return {{low(box.low.x), low(box.low.y), low(box.low.z)}, {high(box.high.x), high(box.high.y), high(box.high.z)}};
}

}  // namespace

PrimitiveSet::PrimitiveSet(const World& world) : world_(world) {
  for (std::uint32_t i = 0; i < world.Instances().size(); ++i) {
    const Instance& instance = world.Instances()[i];
    if (instance.shape->IsDegenerate()) continue;  // never hit
    if (!instance.is_bounded) continue;            // tested separately
    if (instance.is_repeated) continue;            // an earlier one hides it
    const bool is_whole = instance.shared != Instance::not_shared;
    Add(i, is_whole, is_whole ? 1 : static_cast<std::uint32_t>(instance.shape->Elements()));
    if (instance.frame != 0)
      padding_per_distance_ =
          std::max(padding_per_distance_, WorldBoundsPadding(world.Frames()[instance.frame], 0).per_distance);
  }
  constexpr std::size_t short_run = 8;
  if (runs_.size() * short_run > size_ && runs_.size() > 1) {
    run_of_.reserve(size_);
    for (std::uint32_t r = 0; r < runs_.size(); ++r)
      run_of_.resize(r + 1 < runs_.size() ? runs_[r + 1].first : size_, r);
  }
}

PrimitiveSet::PrimitiveSet(const World& world, int number)
    : world_(world), mesh_(world.SharedMeshes()[static_cast<std::size_t>(number)]) {
  Add(0, false, static_cast<std::uint32_t>(mesh_->Elements()));
}

void PrimitiveSet::Add(std::uint32_t instance, bool is_whole, std::uint32_t count) {
  if (count > most_primitives - size_) throw std::length_error("the scene has more than 2^29 primitives");
  runs_.push_back({size_, instance, is_whole});
  size_ += count;
}

R3::Box PrimitiveSet::Bounds(std::uint32_t i) const {
  if (mesh_) return Widened(mesh_->Bounds(static_cast<int>(i)), 0);
  const PrimRef primitive = (*this)[i];
  const Instance& instance = world_.Instances()[primitive.instance];
  // A shared shape is the node's own, and the node of a primitive has no transform.
  const R3::Box local =
      primitive.element == PrimRef::whole ? instance.node->bounds : instance.shape->Bounds(primitive.element);
  if (instance.frame == 0) return Widened(local, 0);
  const R3::Transform& frame = world_.Frames()[instance.frame];
  const R3::Box box = world_.InWorld(instance.frame, local);
  return Widened(box, WorldBoundsPadding(frame, Reach(box)).constant);
}

Hull PrimitiveSet::HullOf(std::uint32_t i) const {
  const PrimRef primitive = (*this)[i];
  const Instance& instance = world_.Instances()[primitive.instance];
  if (!(world_.MotionOf(instance.frame) == R3::Vector{})) return {Bounds(i), {}, &world_.Frames()[0].Inverse(), 0};
  const R3::Transform& frame = world_.Frames()[instance.frame];
  const R3::Box in_world = world_.InWorld(instance.frame, instance.node->bounds);
  const double padding = instance.frame == 0 ? 0 : WorldBoundsPadding(frame, Reach(in_world)).constant;
  if (primitive.element == PrimRef::whole) return {instance.node->bounds, {}, &frame.Inverse(), padding};
  return {instance.shape->Bounds(primitive.element), instance.shape->ProfileInBounds(), &frame.Inverse(), padding};
}

const R3::Mesh* PrimitiveSet::MeshOf(std::uint32_t i) const {
  if (mesh_) return mesh_;
  const Run& run = RunOf(i);
  return run.is_whole ? nullptr : world_.Instances()[run.instance].TwoSidedMesh();
}

std::optional<SphereLeaf> PrimitiveSet::SphereOf(std::uint32_t i) const {
  if (mesh_) return {};
  const std::uint32_t number = RunOf(i).instance;
  const Instance& instance = world_.Instances()[number];
  const auto sphere = instance.frame == 0 ? instance.shape->AsSphere() : std::nullopt;
  if (!sphere) return {};
  return SphereLeaf{*sphere, instance.first_primitive, number};
}

}  // namespace ray

#include "source/accelerate/World.h"

#include <cassert>
#include <unordered_map>

#include "R1/HugePages.h"
#include "R3/OneSided.h"
#include "source/accelerate/BoundsPadding.h"
#include "source/accelerate/Repetitions.h"
#include "source/scene/Singular.h"

namespace ray {
namespace {

std::string LeftOut(const Scene& scene, const Location& location) {
  std::string where = "the scene";
  if (location.line != 0 && location.file < scene.files.size())
    where = scene.files[location.file] + ":" + std::to_string(location.line) + ":" + std::to_string(location.column);
  return where + ": warning: the transforms down to this group cannot be inverted in double precision; it is skipped";
}

/// Moves a mesh to huge pages, since rays access its corners in random order.
void PutOnHugePages(const R3::Mesh& mesh) {
  const R3::MeshData& data = mesh.Data();
  R1::PreferHugePages(data.positions.data(), data.positions.size() * sizeof(data.positions[0]));
  R1::PreferHugePages(data.triangles.data(), data.triangles.size() * sizeof(data.triangles[0]));
}

}  // namespace

/// The transform from the world to a node while the graph is being flattened.
struct World::GroupTransform {
  R3::Product world_from_node;
  R3::Vector motion;  // in the world
  std::uint32_t frame = 0;
};

World::World(const Scene& scene) : scene_(scene) {
  FlattenGraph();
  NumberInstances();
  BoundInstances();
  ProjectTextures();
  BakeOrShareMeshes();
  TakeBacksAway();
  MarkRepetitions(instances_, frames_, motions_);
  MarkParts();
  MarkMedia();
  std::erase_if(unbounded_, [&](std::uint32_t i) { return instances_[i].is_repeated; });
  for (const R3::Mesh* mesh : shared_meshes_) PutOnHugePages(*mesh);
  for (const Instance& instance : instances_)
    if (instance.mesh && instance.shared == Instance::not_shared) PutOnHugePages(*instance.mesh);
}

// Breadth-first and not recursive: the graph may be 100,000 levels deep.
void World::FlattenGraph() {
  frames_.emplace_back();
  motions_.emplace_back();
  nodes_.push_back({.node = &scene_.root});
  std::vector<GroupTransform> transforms{GroupTransform{}};  // of nodes_[i], freed in batches: see below
  std::size_t first = 0;                                     // transforms[0] belongs to nodes_[first]

  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    // Transforms are large and only those of pending nodes are needed; dropping half of them at a time keeps the cost
    // linear.
    if (i - first > 1024 && i - first > transforms.size() / 2) {
      transforms.erase(transforms.begin(), transforms.begin() + static_cast<std::ptrdiff_t>(i - first));
      first = i;
    }
    const Node& node = *nodes_[i].node;
    assert(!node.shape || IsIdentity(node.transform));  // a shape's box is in the frame of the shape itself
    GroupTransform group = transforms[i - first];
    if (!Enter(node, group)) continue;
    nodes_[i].frame = group.frame;
    nodes_[i].first_child = static_cast<std::uint32_t>(nodes_.size());
    if (node.shape) continue;  // the solids below it are part of its shape
    nodes_[i].children = static_cast<std::uint32_t>(node.children.size());
    for (const Node& child : node.children) {
      nodes_.push_back({.node = &child});
      transforms.push_back(group);
    }
  }
}

bool World::Enter(const Node& node, GroupTransform& group) {
  const bool does_move = !(node.motion == R3::Vector{});
  if (IsIdentity(node.transform) && !does_move) return true;
  group.motion = group.motion + frames_[group.frame] * node.motion;
  if (IsSingular(node.transform)) return false;  // the reader has warned
  group.world_from_node = group.world_from_node * node.transform;
  const auto transform = R3::Transform::Of(group.world_from_node);
  if (!transform) {
    warnings_.push_back(LeftOut(scene_, node.location));
    return false;
  }
  group.frame = static_cast<std::uint32_t>(frames_.size());
  frames_.push_back(*transform);
  motions_.push_back(group.motion);
  return true;
}

// Depth-first, so that ids follow the order of the scene file; materials are inherited on the way.
void World::NumberInstances() {
  struct StackEntry {
    std::uint32_t node;
    int material;
  };
  constexpr int default_material = 0;
  std::vector<StackEntry> stack{{0, default_material}};
  while (!stack.empty()) {
    const StackEntry next = stack.back();
    stack.pop_back();
    FlatNode& flat = nodes_[next.node];
    const Node& node = *flat.node;
    const int material = node.material == Node::inherit ? next.material : node.material;
    if (node.shape) {
      flat.instance = static_cast<std::int32_t>(instances_.size());
      moves_ |= !(motions_[flat.frame] == R3::Vector{});
      const bool is_bounded = node.shape->IsBounded();
      if (!is_bounded) unbounded_.push_back(static_cast<std::uint32_t>(flat.instance));
      instances_.push_back({.shape = node.shape.get(),
                            .mesh = dynamic_cast<const R3::Mesh*>(node.shape.get()),
                            .form = node.shape->FormOfElements(),
                            .is_bounded = is_bounded,
                            .material = &scene_.materials[static_cast<std::size_t>(material)],
                            .node = &node,
                            .frame = flat.frame,
                            .first_primitive = primitives_});
      primitives_ += node.shape->Elements();
    }
    for (std::uint32_t k = flat.children; k-- > 0;) stack.push_back({flat.first_child + k, material});
  }
}

void World::ProjectTextures() {
  std::unordered_map<const R3::Mesh*, const R3::Mesh*> projections;
  for (Instance& instance : instances_) {
    if (!instance.material->projects_textures || !instance.mesh || instance.mesh->HasTextureCoordinates()) continue;
    const R3::Mesh*& projected = projections[instance.mesh];
    if (!projected) projected = projected_meshes_.emplace_back(instance.mesh->Projected()).get();
    instance.shape = instance.mesh = projected;
  }
}

void World::BakeOrShareMeshes() {
  std::unordered_map<const R3::Mesh*, int> uses;
  for (const Instance& instance : instances_)
    if (instance.TwoSidedMesh()) ++uses[instance.mesh];
  std::unordered_map<const R3::Mesh*, std::int32_t> numbers;
  for (Instance& instance : instances_) {
    if (!instance.TwoSidedMesh() || instance.mesh->Elements() == 0) continue;
    if (uses[instance.mesh] > 1) {
      const auto number = numbers.try_emplace(instance.mesh, static_cast<std::int32_t>(numbers.size()));
      if (number.second) shared_meshes_.push_back(instance.mesh);
      instance.shared = number.first->second;
    } else if (instance.frame != 0) {
      auto moved = motions_[instance.frame] == R3::Vector{} ? instance.mesh->Moved(frames_[instance.frame]) : nullptr;
      if (!moved) {  // moving or too far away: like a shared mesh, it keeps its frame
        instance.shared = static_cast<std::int32_t>(numbers.size());
        numbers.emplace(instance.mesh, instance.shared);
        shared_meshes_.push_back(instance.mesh);
        continue;
      }
      instance.shape = instance.mesh = moved.get();
      instance.frame = 0;
      baked_meshes_.push_back(std::move(moved));
    }
  }
}

void World::TakeBacksAway() {
  for (Instance& instance : instances_)
    if (instance.material->one_sided)
      instance.shape = one_sided_shapes_.emplace_back(std::make_unique<R3::OneSided>(*instance.shape)).get();
}

void World::MarkParts() {
  for (Instance& instance : instances_) {
    instance.has_parts = !instance.shape->MaterialsOfParts().empty();
    if (!instance.has_parts) continue;
    for (const Material* material : MaterialsOf(instance)) instance.has_clear_parts |= !IsBlack(material->kt);
  }
}

std::vector<const Material*> World::MaterialsOf(const Instance& instance) const {
  std::vector<const Material*> materials{instance.material};
  for (const int part : instance.shape->MaterialsOfParts())
    materials.push_back(&scene_.materials[static_cast<std::size_t>(part)]);
  return materials;
}

const Material& World::MaterialOfPart(const Instance& instance, const R3::Hit& hit) const {
  const int part = instance.shape->MaterialOf(hit);
  return part < 0 ? *instance.material : scene_.materials[static_cast<std::size_t>(part)];
}

void World::MarkMedia() {
  std::unordered_map<const R3::Mesh*, bool> closed;
  const auto is_closed = [&](const Instance& instance) {
    if (!instance.TwoSidedMesh())
      return instance.is_bounded && instance.shape->IsSolid() && !instance.shape->IsDegenerate();
    const auto [found, is_new] = closed.try_emplace(instance.mesh, false);
    if (is_new) found->second = instance.mesh->IsClosed();
    return found->second;
  };
  for (Instance& instance : instances_) {
    const bool matters = instance.IsClear() || !IsBlack(instance.material->absorb);
    instance.is_medium = matters && !instance.is_repeated && is_closed(instance);
  }
}

void World::BoundInstances() {
  for (Instance& instance : instances_) {
    if (instance.is_bounded) instance.bounds = InWorld(instance.frame, instance.node->bounds);
    // The padding exceeds the error by that factor; R3/Departure.h adds what grows with the distance of rays.
    instance.error = WorldBoundsPadding(frames_[instance.frame], Reach(instance.bounds)).constant;
    constexpr double window = 0x1p18 * R3::unit_roundoff;  // see EndOfCoincidence
    coincidence_window_ = std::max(coincidence_window_, window * Reach(instance.bounds));
  }
}

R3::Intersection World::At(const R3::Ray& ray, const WorldHit& hit) const {
  const Instance& instance = instances_[hit.instance];
  R3::Intersection at = instance.shape->At(Back(instance.frame, ray), hit, hit.element);
  BringToWorld(instance.frame, ray.time, at);
  return at;
}

R3::UvTangents World::UvTangentsAt(const R3::Ray& ray, const WorldHit& hit) const {
  const Instance& instance = instances_[hit.instance];
  R3::UvTangents uv = instance.shape->UvTangentsAt(Back(instance.frame, ray), hit, hit.element);
  uv.first = frames_[instance.frame] * uv.first, uv.second = frames_[instance.frame] * uv.second;
  return uv;
}

void World::BringToWorld(std::uint32_t frame, double time, R3::Intersection& at) const {
  if (frame == 0) return;  // the world itself, which does not move
  if (!frames_[frame].IsIdentity()) at = frames_[frame] * at;
  if (moves_) Shift(time * motions_[frame], at);
}

void World::Shift(const R3::Vector& way, R3::Intersection& at) {
  at.position = at.position + way;
  // One sum here, one in the inverse direction.
  at.error = at.error + R3::Gamma(4) * (Abs(FromOrigin(at.position)) + Abs(way));
}

}  // namespace ray

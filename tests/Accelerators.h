#pragma once

#include <string>
#include <vector>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "source/accelerate/Accelerator.h"
#include "source/accelerate/twolevel/TwoLevel.h"
#include "tests/BoundedShapes.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

/// Every way of accelerating, and scenes to try them on.
namespace accelerators {

struct Way {
  std::string name;
  ray::AcceleratorSettings settings;
};

/// Every kind with its defaults, then instruction sets and extremes of sizes.
inline std::vector<Way> EveryWay() {
  std::vector<Way> ways;
  for (const auto* kind : ray::AcceleratorKinds()) ways.push_back({kind->name, {.name = kind->name}});
  for (const std::string& set : ray::InstructionSets())
    for (const char* kind : {"grid", "octree", "bvh"})
      ways.push_back({kind + (", " + set), {.name = kind, .instruction_set = set}});
  const auto add = [&](const char* kind, double resolution, int depth) {
    ways.push_back({kind + (" of " + std::to_string(resolution) + ", " + std::to_string(depth)),
                    {.name = kind, .resolution = resolution, .depth = depth}});
  };
  add("grid", 1e-6, 0);  // one cell
  add("grid", 20, 0);
  add("octree", 1, 40);
  add("octree", 24, 1);
  add("octree", 1e6, 0);  // one leaf
  add("bvh", 1, 0);
  return ways;
}

/// A mesh like a potato, closed; `rings` by `sides`.
inline R3::MeshData BumpyBall(int sides, int rings) {
  R3::MeshData data;
  const auto corner = [&](int side, int ring) {
    const double a = 3.141592653589793 * ring / rings, b = 2 * 3.141592653589793 * side / sides;
    const double r = 1 + 0.2 * std::sin(3 * b) * std::sin(a) + 0.1 * std::cos(5 * a);
    return R3::Point{r * std::sin(a) * std::cos(b), r * std::cos(a), r * std::sin(a) * std::sin(b)};
  };
  data.positions.push_back(corner(0, 0));
  for (int ring = 1; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) data.positions.push_back(corner(side, ring));
  data.positions.push_back(corner(0, rings));
  const auto last = static_cast<std::uint32_t>(data.positions.size()) - 1;
  const auto at = [&](int side, int ring) { return static_cast<std::uint32_t>(1 + (ring - 1) * sides + side % sides); };
  for (int side = 0; side < sides; ++side) {
    data.triangles.push_back({0, at(side, 1), at(side + 1, 1)});
    data.triangles.push_back({last, at(side + 1, rings - 1), at(side, rings - 1)});
    for (int ring = 1; ring < rings - 1; ++ring) {
      data.triangles.push_back({at(side, ring), at(side, ring + 1), at(side + 1, ring + 1)});
      data.triangles.push_back({at(side, ring), at(side + 1, ring + 1), at(side + 1, ring)});
    }
  }
  return data;
}

inline ray::Node Leaf(std::shared_ptr<const R3::Shape> shape) {
  ray::Node node;
  node.shape = std::move(shape);
  SetBounds(node);
  return node;
}

inline ray::Node Group(const R3::Matrix& transform) {
  ray::Node node;
  node.transform = transform;
  return node;
}

/// Groups in groups, sheared, mirrored and scaled by up to `powers` orders of magnitude, with shapes on every level and
/// now and then one of `meshes`, which so are used several times or once.
inline ray::Node RandomGroup(Draw& draw, int levels, double powers,
                             const std::vector<std::shared_ptr<const R3::Mesh>>& meshes,
                             const std::vector<const R3::ShapeKind*>& kinds) {
  ray::Node group;
  if (draw.Whole(0, 3) > 0) group.transform = draw.Affine(powers);
  for (int i = draw.Whole(1, 4); i > 0; --i) {
    if (levels > 0 && draw.Whole(0, 2) > 0) {
      group.children.push_back(RandomGroup(draw, levels - 1, powers, meshes, kinds));
    } else if (!meshes.empty() && draw.Whole(0, 3) == 0) {
      group.children.push_back(
          Leaf(meshes[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(meshes.size()) - 1))]));
    } else {
      const auto* kind = kinds[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(kinds.size()) - 1))];
      group.children.push_back(Leaf(kind->make(kind->example)));
    }
  }
  SetBounds(group);
  return group;
}

inline ray::Scene RandomScene(Draw& draw, double powers,
                              const std::vector<const R3::ShapeKind*>& kinds = BoundedShapeKinds()) {
  std::vector<std::shared_ptr<const R3::Mesh>> meshes;
  for (int i = 0; i < 3; ++i)
    meshes.push_back(std::make_shared<R3::Mesh>(BumpyBall(draw.Whole(3, 12), draw.Whole(3, 8))));
  ray::Scene scene;
  scene.root = RandomGroup(draw, 3, powers, meshes, kinds);
  scene.root.transform = {};
  SetBounds(scene.root);
  return scene;
}

inline void ExpectSame(const std::optional<ray::WorldHit>& a, const std::optional<ray::WorldHit>& b, const R3::Ray& ray,
                       const std::string& how) {
  ASSERT_EQ(a.has_value(), b.has_value()) << how << ' ' << oracle::Hex(ray);
  if (!a) return;
  EXPECT_EQ(a->t, b->t) << how << ' ' << oracle::Hex(ray);
  EXPECT_EQ(a->u, b->u) << how << ' ' << oracle::Hex(ray);
  EXPECT_EQ(a->v, b->v) << how << ' ' << oracle::Hex(ray);
  EXPECT_EQ(a->part, b->part) << how << ' ' << oracle::Hex(ray);
  EXPECT_EQ(a->instance, b->instance) << how << ' ' << oracle::Hex(ray);
  EXPECT_EQ(a->element, b->element) << how << ' ' << oracle::Hex(ray);
}

/// The rays, and of some that hit what cannot be met again, one that leaves it.
inline std::vector<R3::Ray> WithSomeLeaving(const ray::World& world, const ray::Accelerator& accelerator,
                                            std::vector<R3::Ray> rays) {
  ray::Workspace workspace;
  for (std::size_t i = 0, count = rays.size(); i < count; i += 3) {
    const auto hit = accelerator.Intersect(rays[i], workspace);
    if (!hit) continue;
    const R3::Intersection at = world.At(rays[i], *hit);
    const R3::Vector direction = rays[(i + 1) % count].direction;
    const R3::Form form = world.Instances()[hit->instance].form;
    if (form == R3::Form::flat || (form == R3::Form::convex && Dot(at.normal, direction) > 0))
      rays.push_back({.origin = SpawnPoint(at, direction),
                      .direction = direction,
                      .time = rays[i].time,
                      .leaving = world.PrimitiveId(*hit)});
  }
  return rays;
}

/// That all the ways find what testing every primitive finds: the nearest, and whether there is anything within t = 1.
inline void Compare(const ray::World& world, const std::vector<R3::Ray>& given, const std::vector<Way>& ways) {
  const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
  const std::vector<R3::Ray> rays = WithSomeLeaving(world, *none, given);
  ray::Workspace for_none;
  std::vector<std::optional<ray::WorldHit>> hits;
  std::vector<bool> occluded;
  const auto shadow = [](R3::Ray ray) {
    ray.t_max = 1;
    return ray;
  };
  for (const R3::Ray& ray : rays) {
    hits.push_back(none->Intersect(ray, for_none));
    occluded.push_back(none->IsOccluded(shadow(ray), for_none));
  }
  for (const Way& way : ways) {
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    ray::Workspace workspace;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ExpectSame(accelerator->Intersect(rays[i], workspace), hits[i], rays[i], way.name);
      EXPECT_EQ(accelerator->IsOccluded(shadow(rays[i]), workspace), occluded[i])
          << way.name << ' ' << oracle::Hex(rays[i]);
    }
    // And in packets.
    std::vector<R3::Ray> shadows;
    for (const R3::Ray& ray : rays) shadows.push_back(shadow(ray));
    for (std::size_t first = 0, count = 1; first < rays.size(); first += count, count = count % 37 + 5) {
      count = std::min(count, rays.size() - first);
      std::vector<std::optional<ray::WorldHit>> hits_of_packet(count);
      const auto is_occluded = std::make_unique<bool[]>(count);
      accelerator->Intersect(std::span(rays).subspan(first, count), hits_of_packet.data(), workspace);
      accelerator->IsOccluded(std::span(shadows).subspan(first, count), is_occluded.get(), workspace);
      for (std::size_t i = 0; i < count; ++i) {
        ExpectSame(hits_of_packet[i], hits[first + i], rays[first + i], way.name + ", in packets");
        EXPECT_EQ(is_occluded[i], occluded[first + i]) << way.name << ", together " << oracle::Hex(rays[first + i]);
      }
    }
  }
}

/// Rays that go nearly the way of one: from around its origin, in directions around its own, both `spread` times its
/// length apart, of other lengths, now and then with an end.
inline std::vector<R3::Ray> Bundle(Draw& draw, const R3::Ray& ray, int count, double spread_of_origins,
                                   double spread_of_directions) {
  const double length = MaxComponent(Abs(ray.direction));
  std::vector<R3::Ray> list;
  for (int i = 0; i < count; ++i) {
    const double end = draw.Whole(0, 3) ? R3::infinity : draw.Scale(-2, 1);
    list.push_back({ray.origin + spread_of_origins * length * draw.Direction(),
                    draw.Scale(-1, 1) * (ray.direction + spread_of_directions * length * draw.Direction()), 0, end});
  }
  return list;
}

/// Rays at and around the instances of a world: from near and far, along axes, from corners of boxes, and on from
/// where they hit.
inline std::vector<R3::Ray> RaysAt(const ray::World& world, Draw& draw, int count) {
  const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
  const R3::Box& box = world.scene().root.bounds;
  std::vector<R3::Ray> list;
  for (int i = 0; i < count; ++i) {
    const auto& instance =
        world.Instances()[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(world.Instances().size()) - 1))];
    const R3::Box own = world.Frames()[instance.frame] * Bounds(*instance.shape);
    const auto within = [&](const R3::Box& b) {
      return b.low + R3::Vector{b.Size().x * draw.Between(0, 1), b.Size().y * draw.Between(0, 1),
                                b.Size().z * draw.Between(0, 1)};
    };
    const R3::Point target = within(own);
    R3::Point origin = box.Center() + 2 * box.Radius() * draw.Direction();
    switch (draw.Whole(0, 5)) {
      case 0:
      case 1:
        origin = target + 4 * own.Radius() * draw.Direction();
        break;
      case 2:
        origin = target + draw.Scale(0, 9) * box.Radius() * draw.Direction();
        break;
      case 3:
        origin = own.Corner(draw.Whole(0, 7));
        break;
      default:
        break;
    }
    R3::Vector d = draw.Scale(-6, 6) * (target - origin);
    if (draw.Whole(0, 9) == 0) d = {d.x, 0, 0};
    if (draw.Whole(0, 9) == 0) d = {-0.0, d.y, d.z};
    list.push_back({origin, d, draw.Whole(0, 3) ? 0.0 : draw.Between(0, 0.5)});
    ray::Workspace workspace;
    if (const auto hit = none->Intersect(list.back(), workspace))
      list.push_back({SpawnPoint(world.At(list.back(), *hit), -d), -d});
  }
  return list;
}

}  // namespace accelerators

#include "source/integrate/shading/ShadingPoints.h"

#include "R1/Columns.h"
#include "R3/FlatTriangle.h"
#include "R3/Numeric.h"

namespace ray {
namespace {

constexpr std::size_t most = 16;  // so that all numbers fit into a core's first-level cache
using PointColumns = R1::Columns<R3::Point, most>;
using VectorColumns = R1::Columns<R3::Vector, most>;

/// Surfaces that rays have hit, and the data of the points there.
struct Surfaces {
  std::size_t count = 0;
  std::array<ShadingPoint*, most> points;
  std::array<const R3::Ray*, most> rays;
  PointColumns origin, free_point;
  VectorColumns direction, normal, shading_normal, N, wo;
  alignas(64) double begin[most], t[most], error[most];  // of the rays and their hits
  alignas(64) double facing[most], clearance[most];      // n . direction; of departures

  bool IsFull() const { return count == most; }
  void Add(ShadingPoint& p, const R3::Ray& ray, const Instance& instance) {
    points[count] = &p, rays[count] = &ray;
    error[count] = instance.error;
    origin.Set(count, ray.origin), direction.Set(count, ray.direction);
    begin[count] = std::max(ray.t_min, 0.0), t[count] = p.hit.t;
    ++count;
  }
};

/// Surfaces of flat triangles: one object whose arrays obviously do not overlap.
struct FlatSurfaces : Surfaces {
  R1::Columns<R3::Point, most> corners[3];

  void Add(ShadingPoint& p, const R3::Ray& ray, const Instance& instance) {
    const auto places = instance.mesh->CornersInPlace(p.hit.element);
    for (std::size_t k = 0; k < 3; ++k) corners[k].Set(count, *places[k]);
    Surfaces::Add(p, ray, instance);
  }
};

/// Surfaces of the world's spheres.
struct RoundSurfaces : Surfaces {
  VectorColumns from_center;  // to the hit point on the ray

  void Add(ShadingPoint& p, const R3::Ray& ray, const Instance& instance, const R3::SphereData& sphere) {
    from_center.Set(count, ray.At(p.hit.t) - sphere.center);
    Surfaces::Add(p, ray, instance);
  }
};

R3_VECTORIZED
void MakeNormals(FlatSurfaces& all) {
  for (std::size_t i = 0; i < all.count; ++i) {
    const R3::Vector normal = R3::FaceDirection(all.corners[0][i], all.corners[1][i], all.corners[2][i]);
    all.normal.Set(i, normal), all.shading_normal.Set(i, normal);
  }
}

R3_VECTORIZED
void MakeNormals(RoundSurfaces& all) {
  for (std::size_t i = 0; i < all.count; ++i) {
    const R3::Vector outward = BranchlessUnit(all.from_center[i]);
    all.normal.Set(i, outward), all.shading_normal.Set(i, outward);
  }
}

R3_VECTORIZED
void FaceRays(Surfaces& all) {
  for (std::size_t i = 0; i < all.count; ++i) {
    const R3::Vector direction = all.direction[i], normal = all.normal[i], shading_normal = all.shading_normal[i];
    all.wo.Set(i, -BranchlessUnit(direction));
    all.facing[i] = Dot(normal, direction);
    all.N.Set(i, all.facing[i] <= 0 ? shading_normal : -shading_normal);
    const R3::FreePoint free =
        R3::FreePointBefore(all.origin[i], direction, all.begin[i], all.t[i], all.facing[i], all.error[i]);
    all.free_point.Set(i, free.place), all.clearance[i] = free.clearance;
  }
}

/// Sets the remaining members, one point at a time.
///   is_smoothed   shading normals may differ from the surfaces'
template <bool is_smoothed>
void Finish(const World& world, const Surfaces& all) {
  for (std::size_t i = 0; i < all.count; ++i) {
    ShadingPoint& p = *all.points[i];
    const R3::Ray& ray = *all.rays[i];
    p.kd = KdAt(world, p);
    p.wo = all.wo[i];
    p.entering = all.facing[i] <= 0;
    p.N = all.N[i];
    if constexpr (is_smoothed) p.is_smoothed = !(all.normal[i] == all.shading_normal[i]);
    if (HasNotMoved(ray, p.hit.t)) [[unlikely]] {
      SetDeparture(world, ray, p);
    } else {
      p.free_point = all.free_point[i];
      p.departure = {all.clearance[i], all.direction[i], nullptr};
    }
    SetLeaving(world, p);
    p.bias = world.scene().shadow_bias;
    AbsorbOnTheWay(ray, p);
  }
}

/// Completes points on flat triangles, on spheres, and on any other surfaces.
class Completion {
 public:
  explicit Completion(const World& world) : world_(world) {}

  void Add(ShadingPoint& p, const R3::Ray& ray) {
    const Instance& instance = world_.Instances()[p.hit.instance];
    p.material = &world_.MaterialAt(p.hit);
    const bool needs_uv = p.material->texture || p.material->specular_map;
    const bool is_plain = instance.frame == 0 && !needs_uv;
    if (p.material->bump || p.material->normal_map)
      p = ShadingPointAt(world_, ray, p.path, p.hit);
    else if (is_plain && instance.mesh && !instance.mesh->IsSmooth())
      AddTo(flat_, p, ray, instance);
    else if (const auto sphere = is_plain ? instance.shape->AsSphere() : std::nullopt)
      AddTo(round_, p, ray, instance, *sphere);
    else
      AddOther(p, ray, instance);
  }
  void CompleteAll() { Complete(flat_), Complete(round_), CompleteOthers(); }

 private:
  template <typename Kind, typename... Surface>
  void AddTo(Kind& surfaces, ShadingPoint& p, const R3::Ray& ray, const Surface&... surface) {
    surfaces.Add(p, ray, surface...);
    if (surfaces.IsFull()) Complete(surfaces);
  }
  template <typename Kind>
  void Complete(Kind& surfaces) {
    MakeNormals(surfaces);
    FaceRays(surfaces);
    for (std::size_t i = 0; i < surfaces.count; ++i) {
      R3::SurfacePoint& at = surfaces.points[i]->at;
      at.normal = at.shading_normal = AsNormal(surfaces.normal[i]);
    }
    Finish<false>(world_, surfaces);
    surfaces.count = 0;
  }

  void AddOther(ShadingPoint& p, const R3::Ray& ray, const Instance& instance) {
    p.at = world_.At(ray, p.hit);
    const std::size_t i = others_.count;
    others_.normal.Set(i, AsVector(p.at.normal)), others_.shading_normal.Set(i, AsVector(p.at.shading_normal));
    others_.Add(p, ray, instance);
    if (others_.IsFull()) CompleteOthers();
  }
  void CompleteOthers() {
    FaceRays(others_);
    Finish<true>(world_, others_);
    others_.count = 0;
  }

  const World& world_;
  FlatSurfaces flat_;
  RoundSurfaces round_;
  Surfaces others_;
};

}  // namespace

void CompleteShadingPoints(const World& world, std::span<const R3::Ray> rays, std::span<const std::uint32_t> ray_of,
                           std::span<ShadingPoint> points) {
  Completion completion(world);
  for (std::size_t i = 0; i < points.size(); ++i) completion.Add(points[i], rays[ray_of[i]]);
  completion.CompleteAll();
}

}  // namespace ray

#include "source/view/ScenePicture.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ray {
namespace {

constexpr std::array finenesses{128, 96, 64, 40, 32, 24, 16, 12, 8, 6};
constexpr int usual_fineness = 40;
constexpr int only_boxes = 0;  // a fineness
constexpr std::int64_t box_triangles = 12, box_vertices = 8;

/// The lights that shade the drawing; fewer than there are when all would take too long.
class DrawnLights {
 public:
  DrawnLights(const Scene& scene, std::int64_t vertices) {
    constexpr double most_evaluations = 2e8;  // some seconds
    constexpr double least = 8;               // as many as the course's viewer has
    std::vector<const Light*> shining;
    for (const auto& light : scene.lights)
      if (!light->IsBlack()) shining.push_back(light.get());
    const double wanted = std::max(least, most_evaluations / static_cast<double>(std::max<std::int64_t>(vertices, 1)));
    const double step = std::max(1.0, static_cast<double>(shining.size()) / wanted);
    for (double i = 0; i < static_cast<double>(shining.size()); i += step)
      lights_.push_back(shining[static_cast<std::size_t>(i)]);
    if (!lights_.empty()) weight_ = static_cast<double>(shining.size()) / static_cast<double>(lights_.size());
  }

  /// Sum of irradiance |N.L|.
  R2::Color At(const R3::Point& p, const R3::Vector& N) const {
    R2::Color sum;
    for (const Light* light : lights_)
      if (const auto from = light->Illuminate(p, {0.5, 0.5}))
        sum += std::abs(Dot(N, Unit(from->to_light))) * from->irradiance;
    return weight_ * sum;
  }

 private:
  std::vector<const Light*> lights_;
  double weight_ = 1;
};

/// How finely to draw, and which share of what can be left out is drawn.
struct Plan {
  int fineness = only_boxes;
  double share = 1;
  std::int64_t vertices = 0;  // about
};

bool IsDrawn(const Instance& instance) { return !instance.shape->IsDegenerate(); }

/// So few elements that all such meshes together do not count: of these nothing is left out.
bool IsSmall(const Instance& instance, const World& world, const PictureBudget& budget) {
  const auto instances = static_cast<std::int64_t>(world.Instances().size());
  return instance.mesh && 24 * instances * instance.mesh->Elements() <= budget.most_vertices;
}

Plan PlanFor(const World& world, const PictureBudget& budget) {
  std::int64_t least = 0;  // triangles
  for (const Instance& instance : world.Instances())
    if (IsDrawn(instance)) least += instance.mesh ? instance.mesh->Elements() : box_triangles;
  Plan plan;
  for (const int fineness : finenesses) {
    std::int64_t all = 0;
    for (const Instance& instance : world.Instances())
      if (IsDrawn(instance))
        all += std::max<std::int64_t>(instance.mesh ? instance.mesh->Elements() : box_triangles, fineness * fineness);
    // Beside a huge mesh a few spheres still have to look round.
    const bool is_little = all - least <= budget.usual_triangles / 4;
    if (fineness > usual_fineness ? all > budget.quick_triangles : all > budget.usual_triangles && !is_little) continue;
    plan.fineness = fineness;
    plan.vertices = all;
    break;
  }
  std::int64_t thinned = 0, whole = 0;  // vertices
  for (const Instance& instance : world.Instances()) {
    if (!IsDrawn(instance)) continue;
    if (instance.mesh)
      (IsSmall(instance, world, budget) ? whole : thinned) += std::int64_t{3} * instance.mesh->Elements();
    else if (plan.fineness == only_boxes)
      thinned += box_vertices;
  }
  const double room = static_cast<double>(std::max<std::int64_t>(budget.most_vertices - whole, 0));
  if (static_cast<double>(thinned) > room) plan.share = room / static_cast<double>(thinned);
  plan.vertices = std::max(plan.vertices, std::min(thinned, budget.most_vertices) + whole);
  return plan;
}

/// Of things that come one by one, an even share.
class Share {
 public:
  explicit Share(double share) : share_(share) {}
  bool TakesNext() {
    const double before = std::floor(static_cast<double>(seen_) * share_);
    return std::floor(static_cast<double>(++seen_) * share_) > before;
  }

 private:
  double share_;
  std::int64_t seen_ = 0;
};

/// The six sides of a box with only its eight corners.
R3::MeshData CornersOf(const R3::Box& box) {
  R3::MeshData data;
  for (int i = 0; i < 8; ++i) {
    data.positions.push_back(box.Corner(i));
    data.normals.push_back(AsNormal(Unit(R3::Vector{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0})));
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    // Bits of a corner's number: with the right hand, from `right` to `upward` turns to the high side of `axis`.
    const std::uint32_t high = 1u << axis, right = 1u << (axis + 1) % 3, upward = 1u << (axis + 2) % 3;
    data.triangles.push_back({high, high | right, high | right | upward});
    data.triangles.push_back({high, high | right | upward, high | upward});
    data.triangles.push_back({0, upward, right | upward});
    data.triangles.push_back({0, right | upward, right});
  }
  return data;
}

class Builder {
 public:
  Builder(const World& world, const DrawingSpace& space, const PictureBudget& budget)
      : world_(world),
        space_(space),
        budget_(budget),
        plan_(PlanFor(world, budget)),
        drawn_lights_(world.scene(), plan_.vertices) {}

  ScenePicture Run() {
    picture_.primitives = world_.Primitives();
    Share share(plan_.share);
    const R3::Shape* last = nullptr;  // instances of one shape often follow each other
    for (const Instance& instance : world_.Instances()) {
      if (!IsDrawn(instance)) continue;
      if (!instance.is_bounded) {
        Add(instance, Spread(instance.shape->Tessellate(finenesses.front()), instance));
        continue;
      }
      if (!instance.mesh && plan_.fineness == only_boxes) {
        if (share.TakesNext()) {
          Add(instance, CornersOf(Bounds(*instance.shape)));
          ++picture_.as_boxes;
        } else {
          ++picture_.left_out;
        }
        last = nullptr;
        continue;
      }
      if (instance.shape != last) data_ = instance.shape->Tessellate(std::max(plan_.fineness, 3));
      last = instance.shape;
      if (instance.mesh && plan_.share < 1 && !IsSmall(instance, world_, budget_)) {
        picture_.left_out +=
            static_cast<std::int64_t>(std::erase_if(data_.triangles, [&](const auto&) { return !share.TakesNext(); }));
        last = nullptr;
      }
      Add(instance, data_);
    }
    return std::move(picture_);
  }

 private:
  /// A piece of what has no end, made so large that the scene looks small on it.
  R3::MeshData Spread(R3::MeshData data, const Instance& instance) const {
    const R3::Transform& world_from_local = world_.Frames()[instance.frame];
    const R3::Point &first = data.positions.front(), middle = first + 0.5 * (data.positions.back() - first);
    const R3::Point center = world_from_local * middle;
    const double reach = times_the_scene * space_.radius + Length(center - space_.center);
    const double factor = reach / Length(world_from_local * first - center);
    for (R3::Point& p : data.positions) p = middle + factor * (p - middle);
    return data;
  }

  void Add(const Instance& instance, const R3::MeshData& data) {
    const R3::Transform& world_from_local = world_.Frames()[instance.frame];
    const Material& material = *instance.material;
    const bool is_flat = data.normals.empty();
    auto& vertices = picture_.triangles.vertices;
    const std::size_t first = vertices.size();
    vertices.resize(first + (is_flat ? 3 * data.triangles.size() : data.positions.size()));

    const auto vertex = [&](std::size_t i, const R3::Normal& normal) {
      const R3::Point p = world_from_local * data.positions[i];
      const R2::Point uv = data.uvs.empty() ? R2::Point{} : data.uvs[i];
      return Vertex{space_.At(p), ColorAt(material, p, AsVector(world_from_local * normal), uv)};
    };
    if (is_flat)
      ForAll(data.triangles.size(), [&](std::size_t t) {
        const auto& triangle = data.triangles[t];
        const R3::Point& a = data.positions[triangle[0]];
        const R3::Normal front =
            AsNormal(Unit(Cross(data.positions[triangle[1]] - a, data.positions[triangle[2]] - a)));
        for (std::size_t k = 0; k < 3; ++k) vertices[first + 3 * t + k] = vertex(triangle[k], front);
      });
    else
      ForAll(data.positions.size(), [&](std::size_t i) { vertices[first + i] = vertex(i, data.normals[i]); });

    const bool is_clear = Luminance(material.kt) > 0;
    auto& indices = is_clear ? picture_.triangles.clear : picture_.triangles.opaque;
    for (std::size_t t = 0; t < data.triangles.size(); ++t) {
      std::array<std::uint32_t, 3> corners = data.triangles[t];
      if (is_flat)
        for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(3 * t + k);
      if (world_from_local.Mirrors()) std::swap(corners[1], corners[2]);  // fronts stay outside
      for (const std::uint32_t corner : corners) indices.push_back(static_cast<std::uint32_t>(first) + corner);
    }
  }

  Rgba ColorAt(const Material& m, const R3::Point& p, const R3::Vector& N, const R2::Point& uv) const {
    const R2::Color kd = m.texture ? m.kd * m.texture->At(uv) : m.kd;
    const R2::Color color = m.emission + m.ka * world_.scene().ambient + kd * drawn_lights_.At(p, N);
    return Shown(color, std::clamp(1 - Luminance(m.kt), 0.0, 1.0));
  }

  template <typename Body>
  static void ForAll(std::size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& r) {
      for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
    });
  }

  const World& world_;
  const DrawingSpace& space_;
  const PictureBudget& budget_;
  Plan plan_;
  DrawnLights drawn_lights_;
  R3::MeshData data_;
  ScenePicture picture_;
};

}  // namespace

ScenePicture PictureOf(const World& world, const DrawingSpace& space, const PictureBudget& budget) {
  return Builder(world, space, budget).Run();
}

}  // namespace ray

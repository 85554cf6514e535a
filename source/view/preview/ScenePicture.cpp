#include "source/view/preview/ScenePicture.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "R1/Elementary.h"
#include "source/integrate/shading/Bsdf.h"
#include "source/view/preview/Floats.h"

namespace ray {
namespace {

// The finest leaves out less than a third of a pixel of a circle as wide as a drawing of 512 pixels: 256 (1 - cos(pi /
// 64)).
constexpr std::array finenesses{64, 40, 32, 24, 16, 12, 8, 6};
constexpr int usual_fineness = 40;
constexpr int only_boxes = 0;  // a fineness
constexpr std::int64_t box_triangles = 12, box_vertices = 8;

/// How finely to draw, and which share of what can be left out is drawn.
struct Plan {
  int fineness = only_boxes;
  double share = 1;
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

/// The angle at which Phong's lobe is half as strong as in the middle, on both sides.
double LobeWidth(double exponent) { return 2 * R1::Acos(R1::Pow(0.5, 1 / std::max(exponent, 1.0))); }

bool HasImages(const Material& m) { return m.texture || m.specular_map || m.bump || m.normal_map; }

SurfaceMaterial LookOf(const Material& m, const Scene& scene, const DrawingSpace& space, const TraceSettings& trace) {
  SurfaceMaterial look;
  look.emission = m.emission;
  look.ambient = m.ka * scene.ambient;
  look.kd = m.kd, look.ks = m.ks, look.kr = m.kr, look.kt = m.kt;
  look.n = m.n, look.ir = m.ir, look.coat = m.coat;
  look.lobe = IsGlossy(m, trace) ? LobeWidth(GlossExponent(m)) : 0;
  look.texture = m.texture, look.specular_map = m.specular_map, look.bump = m.bump, look.normal_map = m.normal_map;
  look.texture_scale = m.texture_scale;
  look.texture_multiplies_ambient = m.texture_multiplies_ka;
  look.has_vertex_colors = m.has_vertex_colors;
  look.one_sided = m.one_sided;
  look.bump_height = m.bump_height / space.radius;
  return look;
}

/// What is left of light on half the mean way through a shape, since its surface is drawn twice, before and behind.
R2::Color LeftInside(const Material& m, double mean_way) {
  const auto left = [&](double absorb) { return absorb > 0 ? R1::Exp(-absorb * mean_way / 2) : 1; };
  return {left(m.absorb.r), left(m.absorb.g), left(m.absorb.b)};
}

/// A batch while it grows.
struct Draft {
  SurfaceBatch batch;
  std::vector<std::uint32_t> indices;
  double ways = 0;  // sum of the mean ways through its shapes
  int shapes = 0;
};

class Builder {
 public:
  Builder(const World& world, const TraceSettings& trace, const DrawingSpace& space, const PictureBudget& budget)
      : world_(world), trace_(trace), space_(space), budget_(budget), plan_(PlanFor(world, budget)) {
    for (const Instance& instance : world.Instances()) has_textures_ |= HasImages(*instance.material);
    for (const Instance& instance : world.Instances()) has_colors_ |= instance.material->has_vertex_colors;
  }

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
    Join();
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
    for (R2::Point& uv : data.uvs) uv = {factor * uv.x, factor * uv.y};
    return data;
  }

  void Add(const Instance& instance, const R3::MeshData& data) {
    const R3::Transform& world_from_local = world_.Frames()[instance.frame];
    const bool is_flat = data.normals.empty();
    auto& vertices = picture_.surfaces.vertices;
    auto& uvs = picture_.surfaces.uvs;
    const std::size_t first = vertices.size();
    vertices.resize(first + (is_flat ? 3 * data.triangles.size() : data.positions.size()));
    if (has_textures_) uvs.resize(vertices.size());
    auto& colors = picture_.surfaces.colors;
    if (has_colors_) colors.resize(vertices.size(), {1, 1, 1});
    const bool is_colored = instance.material->has_vertex_colors && !data.colors.empty();

    const auto set = [&](std::size_t vertex, std::size_t i, const R3::Normal& normal) {
      const R3::Vector N = AsVector(world_from_local * normal);
      vertices[vertex] = {space_.At(world_from_local * data.positions[i]), Packed(N.x, N.y, N.z)};
      if (is_colored) colors[vertex] = data.colors[i];
      if (has_textures_ && !data.uvs.empty()) uvs[vertex] = {AsFloat(data.uvs[i].x), AsFloat(data.uvs[i].y)};
    };
    if (is_flat)
      ForAll(data.triangles.size(), [&](std::size_t t) {
        const auto& triangle = data.triangles[t];
        const R3::Point& a = data.positions[triangle[0]];
        const R3::Normal front =
            AsNormal(Unit(Cross(data.positions[triangle[1]] - a, data.positions[triangle[2]] - a)));
        for (std::size_t k = 0; k < 3; ++k) set(first + 3 * t + k, triangle[k], front);
      });
    else
      ForAll(data.positions.size(), [&](std::size_t i) { set(first + i, i, data.normals[i]); });
    AddTriangles(DraftFor(instance), data, static_cast<std::uint32_t>(first), world_from_local.Mirrors());
  }

  static void AddTriangles(Draft& draft, const R3::MeshData& data, std::uint32_t first, bool is_mirrored) {
    const bool is_flat = data.normals.empty();
    for (std::size_t t = 0; t < data.triangles.size(); ++t) {
      std::array<std::uint32_t, 3> corners = data.triangles[t];
      if (is_flat)
        for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(3 * t + k);
      if (is_mirrored) std::swap(corners[1], corners[2]);  // fronts stay outside
      for (const std::uint32_t corner : corners) draft.indices.push_back(first + corner);
    }
  }

  Draft& DraftFor(const Instance& instance) {
    const Material* material = instance.material;
    const auto [found, is_new] = number_of_.try_emplace(material, drafts_.size());
    if (is_new) {
      drafts_.emplace_back();
      drafts_.back().batch.material = LookOf(*material, world_.scene(), space_, trace_);
      // Where light from the environment alone is shown bent, nothing else is seen through.
      const bool is_bending = material->ir != 1 && world_.scene().environment;
      drafts_.back().batch.is_clear = Luminance(material->kt) > 0 && !is_bending;
    }
    Draft& draft = drafts_[found->second];
    if (instance.is_bounded && !IsBlack(material->absorb)) {
      const R3::Vector size = world_.InWorld(instance.frame, Bounds(*instance.shape)).Size();
      draft.ways += 2.0 / 3 * std::min({size.x, size.y, size.z});
      ++draft.shapes;
      draft.batch.material.kt = material->kt * LeftInside(*material, draft.ways / draft.shapes);
    }
    return draft;
  }

  void Join() {
    Surfaces& surfaces = picture_.surfaces;
    std::size_t all = 0;
    for (const Draft& draft : drafts_) all += draft.indices.size();
    surfaces.indices.reserve(all);
    for (const bool is_clear : {false, true})
      for (Draft& draft : drafts_) {
        if (draft.batch.is_clear != is_clear) continue;
        draft.batch.first = static_cast<std::uint32_t>(surfaces.indices.size());
        draft.batch.count = static_cast<std::uint32_t>(draft.indices.size());
        surfaces.indices.insert(surfaces.indices.end(), draft.indices.begin(), draft.indices.end());
        surfaces.batches.push_back(std::move(draft.batch));
        std::vector<std::uint32_t>().swap(draft.indices);  // frees its memory at once
      }
  }

  template <typename Body>
  static void ForAll(std::size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& r) {
      for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
    });
  }

  const World& world_;
  const TraceSettings& trace_;
  const DrawingSpace& space_;
  const PictureBudget& budget_;
  Plan plan_;
  bool has_textures_ = false, has_colors_ = false;
  std::vector<Draft> drafts_;
  std::unordered_map<const Material*, std::size_t> number_of_;
  R3::MeshData data_;
  ScenePicture picture_;
};

}  // namespace

ScenePicture PictureOf(const World& world, const RenderSettings& settings, const DrawingSpace& space,
                       const PictureBudget& budget) {
  const Scene& scene = world.scene();
  ScenePicture picture = Builder(world, settings.trace, space, budget).Run();
  picture.lights = PreviewLightsOf(world, settings, space);
  picture.background = scene.background;
  picture.environment = scene.environment;
  if (scene.environment)
    picture.diffuse_light = DiffuseLightOf(*scene.environment);
  else if (settings.mode == RenderMode::path)
    picture.diffuse_light = DiffuseLightOf(scene.background);
  picture.fresnel = settings.trace.fresnel;
  return picture;
}

}  // namespace ray

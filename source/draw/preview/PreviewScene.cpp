#include "source/draw/preview/PreviewScene.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "R1/Elementary.h"
#include "source/draw/Drawing.h"
#include "source/draw/preview/SimplifiedMesh.h"

namespace ray {
namespace {

// The finest level deviates by less than a third of a pixel from a circle as wide as a drawing of 512 pixels: 256 (1 -
// cos(pi / 64)).
constexpr int finest = 64, coarsest = 6;
constexpr std::int64_t box_triangles = 12;
constexpr std::int64_t least_simplified = 200;  // triangles of a mesh; with fewer it would be unrecognizable

/// The detail of a preview.
struct Detail {
  int fineness = 0;       // of shapes, as in Shape::Tessellate; 0: boxes
  double mesh_share = 1;  // share of the triangles of meshes that simplification keeps
  double box_share = 1;   // share of boxes that are drawn
};

bool IsDrawn(const Instance& instance) { return !instance.shape->IsDegenerate(); }

/// Returns the number of drawn triangles of a mesh; 0 for its box.
std::int64_t TrianglesOf(const Instance& mesh, const Detail& detail) {
  const std::int64_t all = mesh.mesh->Elements();
  if (detail.mesh_share >= 1 || all <= box_triangles) return all;
  const auto wanted = static_cast<std::int64_t>(detail.mesh_share * static_cast<double>(all));
  if (wanted < box_triangles) return 0;
  return std::min(all, std::max(least_simplified, wanted));
}

Detail DetailFor(const World& world, const PreviewBudget& budget) {
  std::int64_t shapes = 0, triangles = 0;
  for (const Instance& instance : world.Instances()) {
    if (!IsDrawn(instance)) continue;
    if (instance.mesh)
      triangles += instance.mesh->Elements();
    else
      ++shapes;
  }
  Detail detail;
  const double each =
      static_cast<double>(budget.shape_triangles) / static_cast<double>(std::max<std::int64_t>(shapes, 1));
  const int fineness = std::min(finest, static_cast<int>(std::sqrt(each)));
  if (fineness >= coarsest) detail.fineness = fineness;
  if (triangles > budget.mesh_triangles)
    detail.mesh_share = static_cast<double>(budget.mesh_triangles) / static_cast<double>(triangles);
  std::int64_t boxes = 0;
  for (const Instance& instance : world.Instances())
    if (IsDrawn(instance)) boxes += instance.mesh ? TrianglesOf(instance, detail) == 0 : detail.fineness == 0;
  if (boxes > budget.boxes) detail.box_share = static_cast<double>(budget.boxes) / static_cast<double>(boxes);
  return detail;
}

/// Selects an even share of a sequence of objects.
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

/// Returns the six sides of a box with only its eight corners.
R3::MeshData CornersOf(const R3::Box& box) {
  R3::MeshData data;
  for (int i = 0; i < 8; ++i) {
    data.positions.push_back(box.Corner(i));
    data.normals.push_back(AsNormal(Unit(R3::Vector{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0})));
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    // Bits of a corner's number: with the right hand, rotation from `right` to `upward` points to the high side of
    // `axis`.
    const std::uint32_t high = 1u << axis, right = 1u << (axis + 1) % 3, upward = 1u << (axis + 2) % 3;
    data.triangles.push_back({high, high | right, high | right | upward});
    data.triangles.push_back({high, high | right | upward, high | upward});
    data.triangles.push_back({0, upward, right | upward});
    data.triangles.push_back({0, right | upward, right});
  }
  return data;
}

/// Returns a unit normal in the units of a vertex.
std::array<std::int16_t, 4> Packed(const R3::Vector& normal) {
  const auto channel = [](double c) { return static_cast<std::int16_t>(c * 32767); };
  return {channel(normal.x), channel(normal.y), channel(normal.z), 0};
}

SurfaceMaterial MaterialFor(const Material& m, const Scene& scene) {
  SurfaceMaterial look;
  look.emission = m.emission;
  look.ambient = m.ka * scene.ambient;
  look.kd = m.kd, look.ks = m.ks, look.kr = m.kr, look.kt = m.kt;
  look.n = m.n;
  look.texture = m.texture;
  look.texture_scale = m.texture_scale;
  look.texture_multiplies_ambient = m.texture_multiplies_ka;
  look.one_sided = m.one_sided;
  return look;
}

/// A batch while it is built.
struct Draft {
  SurfaceBatch batch;
  std::vector<std::uint32_t> indices;
};

class Builder {
 public:
  Builder(const World& world, const DrawingSpace& space, const PreviewBudget& budget)
      : world_(world), space_(space), detail_(DetailFor(world, budget)) {
    for (const Instance& instance : world.Instances()) {
      for (const Material* material : world.MaterialsOf(instance)) has_textures_ |= material->texture != nullptr;
      has_colors_ |= instance.material->has_vertex_colors;
    }
  }

  PreviewScene Run() {
    Share share(detail_.box_share);
    const R3::Shape* last = nullptr;  // instances of one shape are often adjacent
    for (const Instance& instance : world_.Instances()) {
      if (!IsDrawn(instance)) continue;
      if (!instance.is_bounded) {
        Add(instance, Spread(instance.shape->Tessellate(finest), instance));
        continue;
      }
      const std::int64_t triangles = instance.mesh ? TrianglesOf(instance, detail_) : detail_.fineness;
      if (triangles == 0) {
        const bool is_taken = share.TakesNext();
        if (is_taken) Add(instance, CornersOf(Bounds(*instance.shape)));
        ++(is_taken ? preview_.as_boxes : preview_.left_out);
        continue;
      }
      if (instance.shape != last) data_ = instance.shape->Tessellate(std::max(detail_.fineness, coarsest));
      if (instance.mesh && triangles < instance.mesh->Elements()) {
        if (instance.shape != last) data_ = SimplifiedMesh(data_, triangles);
        ++preview_.simplified;
      }
      last = instance.shape;
      Add(instance, data_);
    }
    Join();
    return std::move(preview_);
  }

 private:
  /// Returns a piece of an infinite shape, extended so that its edge is indistinguishable from the horizon: at 10,000
  /// radii, an eye one radius above it sees the edge 1e-4 radians below the horizon.
  R3::MeshData Spread(R3::MeshData data, const Instance& instance) const {
    const R3::Transform& world_from_local = world_.Frames()[instance.frame];
    const R3::Point &first = data.positions.front(), middle = first + 0.5 * (data.positions.back() - first);
    const R3::Point center = world_from_local * middle;
    constexpr double to_the_horizon = 1e4;  // radii of the scene
    const double reach = to_the_horizon * space_.radius + Length(center - space_.center);
    const double factor = reach / Length(world_from_local * first - center);
    for (R3::Point& p : data.positions) p = middle + factor * (p - middle);
    for (R2::Point& uv : data.uvs) uv = {factor * uv.x, factor * uv.y};
    return data;
  }

  void Add(const Instance& instance, const R3::MeshData& data) {
    const R3::Transform& world_from_local = world_.Frames()[instance.frame];
    const bool is_flat = data.normals.empty();
    auto& vertices = preview_.surfaces.vertices;
    auto& uvs = preview_.surfaces.uvs;
    const std::size_t first = vertices.size();
    vertices.resize(first + (is_flat ? 3 * data.triangles.size() : data.positions.size()));
    if (has_textures_) uvs.resize(vertices.size());
    auto& colors = preview_.surfaces.colors;
    if (has_colors_) colors.resize(vertices.size(), {1, 1, 1});
    const bool is_colored = instance.material->has_vertex_colors && !data.colors.empty();

    const auto set = [&](std::size_t vertex, std::size_t i, const R3::Normal& normal) {
      const R3::Vector N = AsVector(world_from_local * normal);
      vertices[vertex] = {space_.At(world_from_local * data.positions[i]), Packed(N)};
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
    AddTriangles(instance, data, static_cast<std::uint32_t>(first), world_from_local.Mirrors());
  }

  void AddTriangles(const Instance& instance, const R3::MeshData& data, std::uint32_t first, bool is_mirrored) {
    const bool is_flat = data.normals.empty();
    const Material* last = nullptr;
    Draft* draft = nullptr;
    for (std::size_t t = 0; t < data.triangles.size(); ++t) {
      const Material& shown = instance.has_parts ? MaterialBeneath(instance, data, t) : *instance.material;
      if (&shown != last) draft = &DraftFor(shown), last = &shown;
      std::array<std::uint32_t, 3> corners = data.triangles[t];
      if (is_flat)
        for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(3 * t + k);
      if (is_mirrored) std::swap(corners[1], corners[2]);  // fronts stay outside
      for (const std::uint32_t corner : corners) draft->indices.push_back(first + corner);
    }
  }

  /// Returns the material of the part whose surface is nearest to the middle of a triangle, on the line across it.
  const Material& MaterialBeneath(const Instance& instance, const R3::MeshData& data, std::size_t triangle) const {
    const auto& corners = data.triangles[triangle];
    const R3::Point& a = data.positions[corners[0]];
    const R3::Vector ab = data.positions[corners[1]] - a, ac = data.positions[corners[2]] - a;
    const R3::Point middle = a + (ab + ac) / 3;
    const R3::Vector reach = (Length(ab) + Length(ac)) * Unit(Cross(ab, ac));
    R3::Ray ray{middle + reach, -reach, 0, 2};
    WorldHit nearest;
    nearest.instance = static_cast<std::uint32_t>(&instance - world_.Instances().data());
    double least = R3::infinity;
    while (const auto hit = instance.shape->Intersect(ray, 0)) {
      const bool faces = Dot(instance.shape->At(ray, *hit, 0).normal, reach) > 0;
      const double off = std::abs(hit->t - 1);
      if (faces && off < least) static_cast<R3::Hit&>(nearest) = *hit, least = off;
      ray.t_min = hit->t;
    }
    return least < R3::infinity ? world_.MaterialAt(nearest) : *instance.material;
  }

  Draft& DraftFor(const Material& material) {
    const auto [found, is_new] = number_of_.try_emplace(&material, drafts_.size());
    if (is_new) {
      drafts_.emplace_back();
      drafts_.back().batch.material = MaterialFor(material, world_.scene());
      drafts_.back().batch.is_clear = Luminance(material.kt) > 0;
    }
    return drafts_[found->second];
  }

  void Join() {
    Surfaces& surfaces = preview_.surfaces;
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
  const DrawingSpace& space_;
  const Detail detail_;
  bool has_textures_ = false, has_colors_ = false;
  std::vector<Draft> drafts_;
  std::unordered_map<const Material*, std::size_t> number_of_;  // of drafts
  R3::MeshData data_;
  PreviewScene preview_;
};

/// Returns the mean over all directions.
R2::Color MeanRadiance(const Environment& environment) {
  constexpr int columns = 64;
  const R2::Image map = Shrunk(environment.Map(), columns, columns / 2);
  R2::Color sum;
  double weights = 0;
  for (int y = 0; y < map.Height(); ++y) {
    const double weight = R1::Cos(std::numbers::pi * ((y + 0.5) / map.Height() - 0.5));  // of the row's solid angle
    for (int x = 0; x < map.Width(); ++x) sum += weight * map.At(x, y), weights += weight;
  }
  return sum / weights;
}

}  // namespace

PreviewScene PreviewOf(const World& world, const RenderSettings& settings, const DrawingSpace& space,
                       const PreviewBudget& budget) {
  const Scene& scene = world.scene();
  PreviewScene preview = Builder(world, space, budget).Run();
  preview.lights = PreviewLightsOf(world, settings, space);
  preview.background = scene.background;
  preview.environment = scene.environment;
  if (scene.environment)
    preview.around = MeanRadiance(*scene.environment);
  else if (settings.mode == RenderMode::path)
    preview.around = scene.background;
  return preview;
}

R2::Image Shrunk(const R2::Image& image, int width, int height) {
  if (image.Width() <= width && image.Height() <= height) return image;
  R2::Image shrunk(std::min(width, image.Width()), std::min(height, image.Height()));
  const auto edge = [](int i, int count, int of) { return static_cast<int>(std::int64_t{i} * of / count); };
  for (int y = 0; y < shrunk.Height(); ++y) {
    const int bottom = edge(y, shrunk.Height(), image.Height()), top = edge(y + 1, shrunk.Height(), image.Height());
    for (int x = 0; x < shrunk.Width(); ++x) {
      const int left = edge(x, shrunk.Width(), image.Width()), right = edge(x + 1, shrunk.Width(), image.Width());
      R2::Color sum;
      for (int j = bottom; j < top; ++j)
        for (int i = left; i < right; ++i) sum += image.At(i, j);
      shrunk.Set(x, y, sum / ((right - left) * (top - bottom)));
    }
  }
  return shrunk;
}

}  // namespace ray

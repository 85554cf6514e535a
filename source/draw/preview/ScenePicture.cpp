#include "source/draw/preview/ScenePicture.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "R1/Elementary.h"
#include "source/draw/Drawing.h"
#include "source/draw/preview/SimplifiedMesh.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray {
namespace {

// The finest leaves out less than a third of a pixel of a circle as wide as a drawing of 512 pixels: 256 (1 - cos(pi /
// 64)).
constexpr std::array finenesses{64, 40, 32, 24, 16, 12, 8, 6};
constexpr int usual_fineness = 40;
constexpr int only_boxes = 0;                   // a fineness
constexpr std::int64_t most_bounces_shown = 4;  // of mirrors in mirrors
constexpr std::int64_t box_triangles = 12, box_vertices = 8;
constexpr std::int64_t least_simplified = 200;  // triangles of a mesh, below which it would be a lump

/// How finely to draw, and which share of what can be left out is drawn.
struct Plan {
  int fineness = only_boxes;
  double share = 1, mesh_share = 1;  // the latter of the triangles of meshes, by simplifying them
  std::int64_t triangles = 0;        // about as many
};

bool IsDrawn(const Instance& instance) { return !instance.shape->IsDegenerate(); }

/// So few elements that all such meshes together do not count: of these nothing is left out.
bool IsSmall(const Instance& instance, const World& world, const PictureBudget& budget) {
  const auto instances = static_cast<std::int64_t>(world.Instances().size());
  return instance.mesh && 24 * instances * instance.mesh->Elements() <= budget.most_vertices;
}

/// The share of the triangles of meshes that is wanted.
double ShareOfMeshes(const World& world, const PictureBudget& budget) {
  std::int64_t triangles = 0;
  for (const Instance& instance : world.Instances())
    if (IsDrawn(instance) && instance.mesh) triangles += instance.mesh->Elements();
  if (triangles <= budget.mesh_triangles) return 1;
  return static_cast<double>(budget.mesh_triangles) / static_cast<double>(triangles);
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
    plan.triangles = all;
    break;
  }
  if (plan.fineness == only_boxes) plan.triangles = least;
  plan.mesh_share = ShareOfMeshes(world, budget);
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

/// Selects an even share of things that come one by one.
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
  look.flat_painted = m.color.value_or(m.kd);
  if (!m.color) look.flat_plain = m.kr + m.kt;
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
  Builder(const World& world, const RenderSettings& settings, const DrawingSpace& space, const PictureBudget& budget)
      : world_(world), trace_(settings.trace), space_(space), budget_(budget), plan_(PlanFor(world, budget)) {
    has_textures_ = settings.mode == RenderMode::uv || settings.mode == RenderMode::uv_color;  // which show them
    for (const Instance& instance : world.Instances()) {
      for (const Material* material : world.MaterialsOf(instance)) has_textures_ |= HasImages(*material);
      has_colors_ |= instance.material->has_vertex_colors;
    }
    if (trace_.max_depth > 0) PlaceProbes();
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
      if (instance.shape != last) data_ = Triangles(instance);
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
  /// An object that mirrors or bends light, and how large it looks from outside.
  struct Mirror {
    const Instance* instance;
    R3::Point middle;
    double size;
  };

  static bool Mirrors(const Material& m) {
    const bool bends = m.ir != 1 && !IsBlack(m.kt);
    return !IsBlack(m.kr) || bends || m.coat > 0;
  }

  /// For an endless surface, the place nearest to the middle of the scene, a little off the surface.
  R3::Point MiddleOfEndless(const Instance& instance) const {
    constexpr double off_surface = 0.05;  // radii of the scene
    const R3::MeshData data = instance.shape->Tessellate(finenesses.back());
    const R3::Transform& world_from_local = world_.Frames()[instance.frame];
    const R3::Point on = world_from_local * data.positions[data.positions.size() / 2];
    const R3::Vector n = Unit(AsVector(world_from_local * data.normals.front()));
    const double height = Dot(space_.center - on, n);
    return space_.center - height * n + (height < 0 ? -off_surface : off_surface) * space_.radius * n;
  }

  /// All mirrors, the largest first.
  std::vector<Mirror> FindMirrors() const {
    std::vector<Mirror> mirrors;
    for (const Instance& instance : world_.Instances()) {
      if (!IsDrawn(instance) || !Mirrors(*instance.material)) continue;
      if (!instance.is_bounded) {
        mirrors.push_back({&instance, MiddleOfEndless(instance), R3::infinity});
      } else {
        const R3::Box box = world_.InWorld(instance.frame, Bounds(*instance.shape));
        mirrors.push_back({&instance, box.Center(), box.Radius()});
      }
    }
    std::ranges::stable_sort(mirrors, [](const Mirror& a, const Mirror& b) { return a.size > b.size; });
    return mirrors;
  }

  /// The largest mirrors have a probe each, others share that of the nearest.
  void PlaceProbes() {
    std::vector<R3::Point> places;
    const auto most = static_cast<std::size_t>(std::min<std::int64_t>(TimesInProbes(1), most_mirror_probes));
    if (most == 0) return;
    for (const Mirror& mirror : FindMirrors()) {
      const double close = 1e-3 * space_.radius;  // as the two triangles of a square
      const auto same =
          std::ranges::find_if(places, [&](const R3::Point& place) { return Length(place - mirror.middle) < close; });
      if (same != places.end()) {
        probe_of_[mirror.instance] = static_cast<int>(same - places.begin());
        owners_.insert(mirror.instance);
        continue;
      }
      if (places.size() < most) {
        probe_of_[mirror.instance] = static_cast<int>(places.size());
        owners_.insert(mirror.instance);
        places.push_back(mirror.middle);
        // A small part of the object, as far as depths of 24 bits allow.
        constexpr double part = 0.05, least = 2e-5, most_near = 2e-3;
        picture_.surfaces.probes.push_back(
            {space_.At(mirror.middle), std::clamp(part * mirror.size / space_.radius, least, most_near)});
        continue;
      }
      const auto nearest =
          std::ranges::min_element(places, {}, [&](const R3::Point& place) { return Length(place - mirror.middle); });
      probe_of_[mirror.instance] = static_cast<int>(nearest - places.begin());
    }
    const auto probes = static_cast<std::int64_t>(places.size());
    if (probes == 0) return;
    const auto times = std::clamp<std::int64_t>(TimesInProbes(probes), 1, most_bounces_shown);
    picture_.mirror_bounces = static_cast<int>(times);
  }

  /// How often so many probes can be filled in about a second of a renderer in software.
  std::int64_t TimesInProbes(std::int64_t probes) const {
    constexpr std::int64_t most_triangles = 24'000'000, sides = 6;
    return most_triangles / std::max<std::int64_t>(1, sides * probes * plan_.triangles);
  }

  /// A piece of what has no end, made so large that its edge cannot be told from the horizon: at 10,000 radii, an eye
  /// one radius above it sees the edge 1e-4 radians below that.
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

  R3::MeshData Triangles(const Instance& instance) const {
    R3::MeshData data = instance.shape->Tessellate(std::max(plan_.fineness, 3));
    if (!instance.mesh || plan_.mesh_share >= 1) return data;
    const double wanted = plan_.mesh_share * static_cast<double>(data.triangles.size());
    return SimplifiedMesh(data, std::max(least_simplified, static_cast<std::int64_t>(wanted)));
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
    AddTriangles(instance, data, static_cast<std::uint32_t>(first), world_from_local.Mirrors());
  }

  void AddTriangles(const Instance& instance, const R3::MeshData& data, std::uint32_t first, bool is_mirrored) {
    const bool is_flat = data.normals.empty();
    const Material* last = nullptr;
    Draft* draft = nullptr;
    for (std::size_t t = 0; t < data.triangles.size(); ++t) {
      const Material& shown = instance.has_parts ? MaterialBeneath(instance, data, t) : *instance.material;
      if (&shown != last) draft = &DraftFor(instance, shown), last = &shown;
      std::array<std::uint32_t, 3> corners = data.triangles[t];
      if (is_flat)
        for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(3 * t + k);
      if (is_mirrored) std::swap(corners[1], corners[2]);  // fronts stay outside
      for (const std::uint32_t corner : corners) draft->indices.push_back(first + corner);
    }
  }

  /// The material of the part whose surface is nearest to the middle of a triangle, on the line across it.
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

  Draft& DraftFor(const Instance& instance, const Material& shown) {
    const Material* material = &shown;
    const auto probe = probe_of_.find(&instance);
    const std::tuple key{material, probe == probe_of_.end() ? -1 : probe->second, owners_.contains(&instance)};
    const auto [found, is_new] = number_of_.try_emplace(key, drafts_.size());
    if (is_new) {
      drafts_.emplace_back();
      drafts_.back().batch.probe = std::get<1>(key);
      drafts_.back().batch.owns_probe = std::get<2>(key);
      drafts_.back().batch.material = LookOf(*material, world_.scene(), space_, trace_);
      // Where bent light is shown, nothing is seen through straight on.
      const bool is_bending = material->ir != 1 && (world_.scene().environment || std::get<1>(key) >= 0);
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
  // By material, probe, and whether it owns that.
  std::map<std::tuple<const Material*, int, bool>, std::size_t> number_of_;
  std::set<const Instance*> owners_;                   // of probes
  std::unordered_map<const Instance*, int> probe_of_;  // of mirrors
  R3::MeshData data_;
  ScenePicture picture_;
};

}  // namespace

bool ShowsBackground(RenderMode mode) {
  return !ShowsDepth(mode) && mode != RenderMode::normal && mode != RenderMode::normal_color &&
         mode != RenderMode::uv && mode != RenderMode::uv_color;
}

bool IsPreviewed(RenderMode mode) {
  switch (mode) {
    case RenderMode::whitted:
    case RenderMode::path:
    case RenderMode::depth:
    case RenderMode::normal:
    case RenderMode::uv:
    case RenderMode::albedo:
    case RenderMode::flat:
    case RenderMode::normal_color:
    case RenderMode::uv_color:
    case RenderMode::zbuffer:
    case RenderMode::gooch:
    case RenderMode::toon:
      return true;
    case RenderMode::heat:
    case RenderMode::rays:
    case RenderMode::id:
    case RenderMode::hatching:
      break;
  }
  return false;
}

ScenePicture PictureOf(const World& world, const RenderSettings& settings, const DrawingSpace& space,
                       const PictureBudget& budget) {
  const Scene& scene = world.scene();
  ScenePicture picture = Builder(world, settings, space, budget).Run();
  picture.lights = PreviewLightsOf(world, settings, space);
  picture.background = scene.background;
  picture.environment = scene.environment;
  if (scene.environment)
    picture.diffuse_light = DiffuseLightOf(*scene.environment);
  else if (settings.mode == RenderMode::path)
    picture.diffuse_light = DiffuseLightOf(scene.background);
  picture.fresnel = settings.trace.fresnel;
  picture.shadows = settings.trace.shadows;
  picture.mirror_bounces = static_cast<int>(std::min<std::int64_t>(settings.trace.max_depth, picture.mirror_bounces));
  picture.look = {settings.mode, settings.trace.gooch, settings.trace.toon_bands, settings.trace.zbuffer};
  return picture;
}

}  // namespace ray

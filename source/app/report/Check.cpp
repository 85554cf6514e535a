#include "source/app/report/Check.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>

#include "source/app/report/Questions.h"
#include "source/render/Flare.h"
#include "source/render/SceneFeatures.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

// Rational directions meet edges and vertices of typical models; these do not.
const std::array<R3::Vector, 3> odd_directions{R3::Vector{0.5772156649, 0.6931471806, 0.4342944819},
                                               R3::Vector{-0.3678794412, 0.8346268417, 0.2614972128},
                                               R3::Vector{0.1234987610, -0.4812118251, 0.9159655942}};

int Crossings(const R3::Shape& shape, const R3::Ray& ray) {
  int crossings = 0;
  for (int element = 0; element < shape.Elements(); ++element) {
    R3::Ray rest = ray;  // behind the last crossing
    while (const auto hit = shape.Intersect(rest, element)) {
      rest.t_min = hit->t;
      ++crossings;
    }
  }
  return crossings;
}

bool IsInside(const World& world, const Instance& instance, const R3::Point& point) {
  const auto is_odd = [&](const R3::Vector& direction) {
    const R3::Ray local = world.Frames()[instance.frame].Back(R3::Ray{point, direction});
    return Crossings(*instance.shape, local) % 2 == 1;
  };
  const std::size_t rays = instance.shape->IsSolid() ? 1 : odd_directions.size();
  return std::all_of(odd_directions.begin(), odd_directions.begin() + static_cast<std::ptrdiff_t>(rays), is_odd);
}

/// Returns the planes through the eye that bound the view; a box on the outer side of one of them is not visible. Empty
/// if the camera is not a pinhole, whose view planes bound it.
std::vector<R3::Vector> InwardSides(const Camera& camera, const RenderSettings& settings) {
  if (!camera.IsPinhole()) return {};
  const double x = camera.HalfWidth(), y = camera.HalfHeight(settings.width, settings.height);
  const double left = x * (1 - camera.shift.x), right = x * (1 + camera.shift.x);
  const double below = y - x * camera.shift.y, above = y + x * camera.shift.y;
  return {camera.towards, right * camera.towards - camera.right, left * camera.towards + camera.right,
          above * camera.towards - camera.up, below * camera.towards + camera.up};
}

bool IsOutside(const R3::Box& box, const R3::Point& eye, const R3::Vector& inward) {
  for (int i = 0; i < 8; ++i)
    if (Dot(box.Corner(i) - eye, inward) >= 0) return false;
  return true;
}

bool ReflectsAmbientLight(const Instance& instance) { return !IsBlack(instance.material->ka); }

/// Returns true if the whole instance is on the outer side of one of the planes through the eye.
bool IsOutsideView(const World& world, const Instance& instance, const R3::Point& eye,
                   std::span<const R3::Vector> inward) {
  const R3::Box box = WorldBounds(world, instance);
  return !box.IsEmpty() && std::ranges::any_of(inward, [&](const auto& side) { return IsOutside(box, eye, side); });
}

/// Returns true if the box is a wall of the room around the eye, such as the one behind the camera: the eye is in front
/// of it, at most as far away as the box is wide and high.
bool IsWallAround(const R3::Box& box, const R3::Point& eye) {
  const std::array<double, 3> at{eye.x, eye.y, eye.z}, low{box.low.x, box.low.y, box.low.z},
      high{box.high.x, box.high.y, box.high.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double distance = std::max(low[axis] - at[axis], at[axis] - high[axis]);
    const auto spans = [&](std::size_t i) {
      return low[i] <= at[i] && at[i] <= high[i] && high[i] - low[i] >= distance;
    };
    if (spans((axis + 1) % 3) && spans((axis + 2) % 3)) return true;
  }
  return false;
}

const Camera& CameraOf(const Inspection& inspection) {
  return inspection.settings.view ? *inspection.settings.view : inspection.world.scene().camera;
}

/// Finds the parts of the scene that the camera does not see.
class OutOfView {
 public:
  explicit OutOfView(const Inspection& inspection)
      : world_(inspection.world),
        eye_(CameraOf(inspection).eye),
        inward_(InwardSides(CameraOf(inspection), inspection.settings)) {}
  bool operator()(const Instance& instance) const { return IsOutsideView(world_, instance, eye_, inward_); }

 private:
  const World& world_;
  const R3::Point eye_;
  const std::vector<R3::Vector> inward_;
};

std::string NothingInView(const Inspection& inspection) {
  if (inspection.world.Instances().empty()) return "nothing in the scene can be seen";
  const OutOfView is_outside(inspection);
  return std::ranges::all_of(inspection.world.Instances(), is_outside) ? "nothing in the scene is in view of the camera"
                                                                       : "";
}

std::string Unlit(const Inspection& inspection) {
  if (!ShowsLight(inspection.settings.mode) || IsLit(inspection.world)) return {};
  return std::string("the scene is unlit") + (inspection.world.scene().lights.empty() ? "" : "; every light is black");
}

std::string FlareOfNothing(const Inspection& inspection) {
  const bool is_of_nothing = HasFlare(CameraOf(inspection), inspection.settings) &&
                             ShiningLights(inspection.world, inspection.settings).empty();
  return is_of_nothing ? "-flare has no effect without a light; emissive surfaces have no lens flare" : "";
}

std::string SharesThoughThingsMove(const Inspection& inspection) {
  const bool shares = inspection.settings.share == Sharing::on && inspection.settings.mode == RenderMode::path;
  return shares && inspection.world.Moves() ? "-share has no effect where things move: each path has its own time" : "";
}

/// Reports a camera inside a shape; a view out of glass may be intended. Meshes are tested by -check alone, since that
/// takes time.
std::string CameraInside(const Inspection& inspection) {
  const int solids = SolidsAround(inspection.world, CameraOf(inspection).eye, [&](const Instance& instance) {
    return IsBlack(instance.material->kt) && (inspection.effort == Effort::check || instance.shape->IsSolid());
  });
  return solids > 0 ? "the camera is inside " + Counted(static_cast<std::uint64_t>(solids), "shape") : "";
}

/// Returns true for materials, of languages with a color and weights, whose color has no weight.
bool HasUnusedColor(const Material& m) {
  const bool is_black = IsBlack(m.ka) && IsBlack(m.kd) && IsBlack(m.ks) && IsBlack(m.kr) && IsBlack(m.kt);
  return m.color && !IsBlack(*m.color) && is_black && IsBlack(m.emission) && m.coat == 0;
}

bool HasSpecular(const Material& m) { return !IsBlack(m.ks) || !IsBlack(m.kr); }

/// Returns true for colors of 0 to 255 that should be of 0 to 1. Some scenes reflect a little more than arrives; a
/// scene whose brightest color is less than 16 of 255 would be nearly black.
bool HasKdOfBytes(const Material& m) {
  constexpr double least = 16;
  return std::max({m.kd.r, m.kd.g, m.kd.b}) >= least;
}

bool HasNoUv(const Instance& i) { return !i.shape->HasTextureCoordinates(); }

bool IsEmissiveSolid(const Instance& i) { return i.Emits() && !i.mesh; }

std::vector<std::string> ShapesOutOfView(const Inspection& inspection) {
  const OutOfView is_outside(inspection);
  const R3::Point eye = CameraOf(inspection).eye;
  std::vector<const Instance*> outside;
  for (const Instance& instance : inspection.world.Instances())
    if (is_outside(instance) && !IsWallAround(WorldBounds(inspection.world, instance), eye))
      outside.push_back(&instance);
  if (outside.empty()) return {};
  return {WarningAt(inspection.world, *outside[0]) + "this shape lies outside the view" + AndMore(outside.size())};
}

/// Reports each mesh with triangles that were flipped to agree with their vertex normals.
std::vector<std::string> TurnedMeshes(const Inspection& inspection) {
  std::vector<std::string> mistakes;
  std::set<const R3::Shape*> seen;
  for (const Instance& instance : inspection.world.Instances()) {
    if (!instance.mesh || instance.mesh->TurnedTriangles() == 0 || !seen.insert(instance.node->shape.get()).second)
      continue;
    const auto turned = static_cast<std::uint64_t>(instance.mesh->TurnedTriangles());
    const std::uint32_t line = instance.mesh->FirstTurnedLine();
    mistakes.push_back(WarningAt(inspection.world, instance) + Counted(turned, "triangle") + " of " +
                       std::to_string(instance.mesh->Elements()) + " in this mesh " + (turned == 1 ? "is" : "are") +
                       " wound against the vertex normals" +
                       (line > 0 ? ", the first on line " + std::to_string(line) + " of its file" : "") +
                       "; the normals decide which side is the front");
  }
  return mistakes;
}

// clang-format would split entries over many lines.
// clang-format off
constexpr Question questions[] = {
    {Effort::warning, SceneFault{NothingInView}},
    {Effort::warning, SceneFault{Unlit}},
    {Effort::warning, SceneFault{FlareOfNothing}},
    {Effort::warning, SceneFault{SharesThoughThingsMove}},
    {Effort::warning, SceneFault{CameraInside}},
    {Effort::warning, ShapeFault{"this shape has a texture but no texture coordinates",
      [](const Instance& i, const Inspection&) { return i.material->texture && HasNoUv(i); }}},
    {Effort::warning, ShapeFault{"this shape has a specular map but no texture coordinates",
      [](const Instance& i, const Inspection&) { return i.material->specular_map && HasNoUv(i); }}},
    {Effort::warning, ShapeFault{"this shape has a specular map but neither ks nor a mirror that it could multiply",
      [](const Instance& i, const Inspection&) { return i.material->specular_map && !HasSpecular(*i.material); }}},
    {Effort::warning, ShapeFault{"this shape has a color but no ka, kd or ks, and is black",
      [](const Instance& i, const Inspection& all) {
        const RenderMode mode = all.settings.mode;  // the tones of gooch do not come from materials
        return ShowsLight(mode) && mode != RenderMode::gooch && HasUnusedColor(*i.material);
      }}},
    {Effort::warning, ShapeFault{
      "this shape reflects more than 16 times the light that arrives: kd is from 0 to 1, not from 0 to 255",
      [](const Instance& i, const Inspection&) { return HasKdOfBytes(*i.material); }}},
    {Effort::warning, ShapeFault{"this shape emits but lights nothing in mode whitted; -mode path makes it a light",
      [](const Instance& i, const Inspection& all) {
        return all.settings.mode == RenderMode::whitted && !all.settings.trace.emissive_solids_light &&
               IsEmissiveSolid(i);
      }}},
    {Effort::warning, ShapeFault{
      "this shape emits but lights nothing with -emission color; -emissive_solids on makes it a light",
      [](const Instance& i, const Inspection& all) {
        return all.settings.mode == RenderMode::path && !EmitsRadiance(all.settings) &&
               !all.settings.trace.emissive_solids_light && IsEmissiveSolid(i);
      }}},
    {Effort::check, PlacedFaults{ShapesOutOfView}},
    {Effort::check, PlacedFaults{TurnedMeshes}},
    {Effort::hint, PlacedFaults{LampMistakes}},
    {Effort::hint, PlacedFaults{ContactMistakes}},
};
// clang-format on

}  // namespace

bool IsLit(const World& world) {
  const Scene& scene = world.scene();
  const bool has_ambient_light =
      !IsBlack(scene.ambient) && std::ranges::any_of(world.Instances(), ReflectsAmbientLight);
  return has_ambient_light || scene.environment || std::ranges::any_of(world.Instances(), &Instance::Emits) ||
         !std::ranges::all_of(scene.lights, [](const auto& light) { return light->IsBlack(); });
}

std::string PlaceOf(const World& world, const Instance& instance) {
  const Scene& scene = world.scene();
  const Location& location = instance.node->location;
  if (location.line == 0 || location.file >= scene.files.size()) return "scene";
  return Place(scene.files[location.file], location.line, location.column);
}

R3::Box WorldBounds(const World& world, const Instance& instance) {
  const bool is_baked = instance.shape != instance.node->shape.get();
  // A shape's own transform is the identity, so its node's box is the shape's, in the frame of the instance. That of a
  // baked mesh is in the frame that the mesh has left; visiting its corners takes little time compared with reading
  // them.
  const R3::Box local = is_baked ? R3::Bounds(*instance.shape) : instance.node->bounds;
  return local.IsEmpty() ? local : world.Frames()[instance.frame] * local;
}

bool Holds(const World& world, const Instance& instance, const R3::Point& point) {
  return WorldBounds(world, instance).Contains(point) && IsInside(world, instance, point);
}

int SolidsAround(const World& world, const R3::Point& point, const std::function<bool(const Instance&)>& counts) {
  return static_cast<int>(std::ranges::count_if(world.Instances(), [&](const Instance& instance) {
    return counts(instance) && Holds(world, instance, point);
  }));
}

std::vector<std::string> PlainMistakes(const World& world, const RenderSettings& settings) {
  constexpr std::size_t most_instances = 10'000;  // 4 ms: 1,200 instructions each, counted by cachegrind
  if (world.Instances().size() > most_instances) return {};
  return Ask(questions, {world, settings, nullptr, Effort::warning});
}

std::vector<std::string> RenderHints(const World& world, const Accelerator& accelerator,
                                     const RenderSettings& settings) {
  if (!ShowsLight(settings.mode)) return {};
  return Ask(questions, {world, settings, &accelerator, Effort::hint});
}

std::vector<std::string> LikelyMistakes(const World& world, const RenderSettings& settings) {
  return Ask(questions, {world, settings});
}

}  // namespace ray

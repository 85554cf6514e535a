#include "source/app/report/Check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <span>

#include "source/app/report/ContactCheck.h"
#include "source/app/report/LampCheck.h"
#include "source/render/Flare.h"
#include "source/render/SceneFeatures.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

// Rational directions meet edges and vertices of what people model; these do not.
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

/// Planes through the eye; a box that lies on the outer side of one of them is not seen. None where the camera is no
/// pinhole, whose view planes do not bound.
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

/// One line for all instances that have the fault, with the place of the first.
void Point(std::vector<std::string>& mistakes, const World& world, const std::string& fault,
           const std::function<bool(const Instance&)>& has_fault) {
  const Instance* first = nullptr;
  std::uint64_t count = 0;
  for (const Instance& instance : world.Instances()) {
    if (!has_fault(instance)) continue;
    if (!first) first = &instance;
    ++count;
  }
  if (!first) return;
  mistakes.push_back(PlaceOf(world, *first) + ": warning: this shape " + fault +
                     (count > 1 ? " (and " + std::to_string(count - 1) + " more)" : ""));
}

bool ReflectsAmbientLight(const Instance& instance) { return !IsBlack(instance.material->ka); }

/// Whether all of the instance is on the outer side of one of the planes through the eye.
bool IsOutsideView(const World& world, const Instance& instance, const R3::Point& eye,
                   std::span<const R3::Vector> inward) {
  const R3::Box box = WorldBounds(world, instance);
  return !box.IsEmpty() && std::ranges::any_of(inward, [&](const auto& side) { return IsOutside(box, eye, side); });
}

/// Whether the box is a wall of the room that the eye is in, such as the one behind the camera: the eye is in front of
/// it, and no farther off than it is wide and high.
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

/// Solids around the point that are not clear: inside of glass one may well look out.
int ObstaclesAround(const World& world, const R3::Point& point, bool ask_meshes) {
  return SolidsAround(world, point, [&](const Instance& instance) {
    return IsBlack(instance.material->kt) && (ask_meshes || instance.shape->IsSolid());
  });
}

/// Mistakes in the scene as a whole.
std::vector<std::string> SceneMistakes(const World& world, const RenderSettings& settings, bool ask_meshes) {
  const Scene& scene = world.scene();
  const Camera camera = settings.view.value_or(scene.camera);
  const std::string warning = (scene.files.empty() ? "scene" : Escaped(scene.files[0])) + ": warning: ";
  const auto inward = InwardSides(camera, settings);
  const auto is_outside = [&](const Instance& i) { return IsOutsideView(world, i, camera.eye, inward); };
  std::vector<std::string> mistakes;
  if (world.Instances().empty())
    mistakes.push_back(warning + "nothing in the scene can be seen");
  else if (std::ranges::all_of(world.Instances(), is_outside))
    mistakes.push_back(warning + "nothing in the scene is in view of the camera");
  if (ShowsLight(settings.mode) && !IsLit(world))
    mistakes.push_back(warning + "the scene is unlit" + (scene.lights.empty() ? "" : "; every light is black"));
  if (HasFlare(camera, settings) && ShiningLights(world, settings).empty())
    mistakes.push_back(warning + "-flare has no effect without a light; what emits has no lens flare");
  if (const int solids = ObstaclesAround(world, camera.eye, ask_meshes); solids > 0)
    mistakes.push_back(warning + "the camera is inside " + Counted(static_cast<std::uint64_t>(solids), "shape"));
  return mistakes;
}

/// In languages whose materials have a color and the weights of it.
bool HasUnusedColor(const Material& m) {
  const bool is_black = IsBlack(m.ka) && IsBlack(m.kd) && IsBlack(m.ks) && IsBlack(m.kr) && IsBlack(m.kt);
  return m.color && !IsBlack(*m.color) && is_black && IsBlack(m.emission) && m.coat == 0;
}

bool HasSpecular(const Material& m) { return !IsBlack(m.ks) || !IsBlack(m.kr); }

/// Colors of 0 to 255 where they should be of 0 to 1. Some scenes reflect a little more than arrives; a scene whose
/// brightest color is less than 16 of 255 would be all but black.
bool HasKdOfBytes(const Material& m) {
  constexpr double least = 16;
  return std::max({m.kd.r, m.kd.g, m.kd.b}) >= least;
}

/// Adds the mistakes in single shapes.
void AddShapeMistakes(std::vector<std::string>& mistakes, const World& world, const RenderSettings& settings) {
  const auto has_no_uv = [](const Instance& i) { return !i.shape->HasTextureCoordinates(); };
  Point(mistakes, world, "has a texture but no texture coordinates",
        [&](const Instance& i) { return i.material->texture && has_no_uv(i); });
  Point(mistakes, world, "has a specular map but no texture coordinates",
        [&](const Instance& i) { return i.material->specular_map && has_no_uv(i); });
  Point(mistakes, world, "has a specular map but neither ks nor a mirror that it could multiply",
        [](const Instance& i) { return i.material->specular_map && !HasSpecular(*i.material); });
  if (ShowsLight(settings.mode) && settings.mode != RenderMode::gooch)  // whose tones are no material's
    Point(mistakes, world, "has a color but no ka, kd or ks, and is black",
          [](const Instance& i) { return HasUnusedColor(*i.material); });
  Point(mistakes, world, "reflects more than 16 times the light that arrives: kd is from 0 to 1, not from 0 to 255",
        [](const Instance& i) { return HasKdOfBytes(*i.material); });
  const auto is_emissive_solid = [](const Instance& i) { return !IsBlack(i.material->emission) && !i.mesh; };
  if (settings.mode == RenderMode::whitted && !settings.trace.emissive_solids_light)
    Point(mistakes, world, "emits but lights nothing in mode whitted; -mode path makes it a light", is_emissive_solid);
  if (settings.mode == RenderMode::path && !EmitsRadiance(settings) && !settings.trace.emissive_solids_light)
    Point(mistakes, world, "emits but lights nothing with -emission color; -emissive_solids on makes it a light",
          is_emissive_solid);
}

/// Reports each mesh some of whose triangles were turned around to agree with their vertex normals.
void AddTurnedMeshes(std::vector<std::string>& mistakes, const World& world) {
  std::set<const R3::Shape*> seen;
  for (const Instance& instance : world.Instances()) {
    if (!instance.mesh || instance.mesh->TurnedTriangles() == 0 || !seen.insert(instance.node->shape.get()).second)
      continue;
    const auto turned = static_cast<std::uint64_t>(instance.mesh->TurnedTriangles());
    const std::uint32_t line = instance.mesh->FirstTurnedLine();
    mistakes.push_back(PlaceOf(world, instance) + ": warning: " + Counted(turned, "triangle") + " of " +
                       std::to_string(instance.mesh->Elements()) + " in this mesh " + (turned == 1 ? "is" : "are") +
                       " wound against the vertex normals" +
                       (line > 0 ? ", the first on line " + std::to_string(line) + " of its file" : "") +
                       "; the normals decide which side is the front");
  }
}

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
  // baked mesh is in the frame that the mesh has left; looking at its corners takes little beside reading them.
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
  std::vector<std::string> mistakes = SceneMistakes(world, settings, false);
  AddShapeMistakes(mistakes, world, settings);
  return mistakes;
}

std::vector<std::string> RenderHints(const World& world, const Accelerator& accelerator,
                                     const RenderSettings& settings) {
  std::vector<std::string> hints;
  if (!ShowsLight(settings.mode)) return hints;
  if (settings.mode == RenderMode::whitted && HasFewLamps(world)) hints = LampMistakes(world, settings);
  for (std::string& hint : PlainContactMistakes(world, accelerator, settings)) hints.push_back(std::move(hint));
  return hints;
}

std::vector<std::string> LikelyMistakes(const World& world, const RenderSettings& settings) {
  std::vector<std::string> mistakes = SceneMistakes(world, settings, true);
  AddShapeMistakes(mistakes, world, settings);
  const R3::Point eye = settings.view.value_or(world.scene().camera).eye;
  const auto inward = InwardSides(settings.view.value_or(world.scene().camera), settings);
  Point(mistakes, world, "lies outside the view", [&](const Instance& i) {
    return IsOutsideView(world, i, eye, inward) && !IsWallAround(WorldBounds(world, i), eye);
  });
  AddTurnedMeshes(mistakes, world);
  for (std::string& mistake : LampMistakes(world, settings)) mistakes.push_back(std::move(mistake));
  for (std::string& mistake : ContactMistakes(world, settings)) mistakes.push_back(std::move(mistake));
  return mistakes;
}

}  // namespace ray

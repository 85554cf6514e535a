#include <algorithm>
#include <cstdint>
#include <set>

#include "R3/Mesh.h"
#include "source/app/report/Check.h"
#include "source/integrate/lights/LightSource.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"

namespace ray {
namespace {

template <class Number>
std::string Line(std::string name, const Number& number) {
  constexpr std::size_t column_of_values = 14;
  name.resize(column_of_values, ' ');
  if constexpr (std::is_convertible_v<Number, std::string>)
    return name + number + "\n";
  else
    return name + std::to_string(number) + "\n";
}

template <class Triple>
std::string WithDecimals(int decimals, const Triple& t) {
  return Fixed(t.x, decimals) + " " + Fixed(t.y, decimals) + " " + Fixed(t.z, decimals);
}

/// Returns the decimals of positions: three, and more in a scene smaller than one unit.
int DecimalsFor(const R3::Box& box) {
  constexpr int usual = 3, most = 20;
  int decimals = usual;
  if (box.IsEmpty()) return decimals;
  for (double size = Length(box.Size()); size > 0 && size < 1 && decimals < most; size *= 10) ++decimals;
  return decimals;
}

std::string BoundsText(const R3::Box& box) {
  const int decimals = DecimalsFor(box);
  return box.IsEmpty() ? "empty" : WithDecimals(decimals, box.low) + "  to  " + WithDecimals(decimals, box.high);
}

/// Returns the scene's lights, or the default lights.
std::string LightLines(const World& world, RenderMode mode) {
  const Scene& scene = world.scene();
  if (scene.has_default_lights && mode == RenderMode::path && LightsOfPath(world).empty())
    return Line("lights", "0 (the scene has none; emissive surfaces light it)");
  const auto emitting = static_cast<std::uint64_t>(std::ranges::count_if(world.Instances(), &Instance::Emits));
  const std::string lamps =
      emitting > 0 ? ", and " + Counted(emitting, "shape") + " that emit" + (emitting == 1 ? "s" : "") : "";
  std::string text =
      Line("lights", std::to_string(scene.lights.size()) +
                         (scene.has_default_lights ? " (the default: the scene names none)" : "") + lamps);
  for (const auto& light : scene.lights) text += "  " + light->Describe() + "\n";
  return text;
}

/// The meshes and textures, each counted once however often it is used.
struct Shared {
  std::set<const R3::Mesh*> meshes;
  std::set<const Texture*> textures;
};

Shared FindShared(const World& world) {
  Shared shared;
  for (const Instance& instance : world.Instances())
    if (const auto* mesh = dynamic_cast<const R3::Mesh*>(instance.shape)) shared.meshes.insert(mesh);
  for (const Material& material : world.scene().materials)
    for (const auto* map : {&material.texture, &material.specular_map})
      if (*map) shared.textures.insert(map->get());
  return shared;
}

std::size_t Bytes(const R3::MeshData& data) {
  return data.positions.size() * sizeof(data.positions[0]) + data.triangles.size() * sizeof(data.triangles[0]) +
         data.normals.size() * sizeof(data.normals[0]) + data.uvs.size() * sizeof(data.uvs[0]);
}

std::size_t Triangles(const Shared& shared) {
  std::size_t triangles = 0;
  for (const R3::Mesh* mesh : shared.meshes) triangles += mesh->Data().triangles.size();
  return triangles;
}

/// Returns the memory of the scene, its flattened form and the image; that of an accelerator depends on its kind.
std::size_t Memory(const World& world, const Shared& shared, const RenderSettings& settings) {
  std::size_t bytes = world.Nodes().size() * (sizeof(Node) + sizeof(FlatNode)) +
                      world.Instances().size() * sizeof(Instance) + world.Frames().size() * sizeof(R3::Transform) +
                      static_cast<std::size_t>(RegionOf(settings).Area()) * 3 * sizeof(float);
  for (const R3::Mesh* mesh : shared.meshes) bytes += Bytes(mesh->Data());
  for (const Texture* texture : shared.textures) bytes += texture->image.Channels().size() * sizeof(float);
  return bytes;
}

/// Returns ", projection fisheye of 180.0 degrees"; empty for a pinhole.
std::string ProjectionText(const Camera& camera) {
  if (camera.IsPinhole()) return {};
  const std::string name = std::string(", projection ") + camera.kind->name;
  switch (camera.kind->extent) {
    case CameraExtent::none:
      return name;
    case CameraExtent::angle:
      return name + " of " + Fixed(camera.Extent(), 1) + " degrees";
    case CameraExtent::width:
      return name + ", " + ToText(camera.Extent()) + " wide";
  }
  return name;
}

}  // namespace

std::string SceneSummary(const World& world, const RenderSettings& settings) {
  const Scene& scene = world.scene();
  const Shared shared = FindShared(world);
  std::string text =
      Line("files", scene.files.size()) + Line("nodes", world.Nodes().size()) +
      Line("shapes", world.Instances().size()) + Line("primitives", world.Primitives()) +
      Line("meshes", std::to_string(shared.meshes.size()) + " with " + Counted(Triangles(shared), "triangle")) +
      Line("materials", scene.materials.size()) + Line("textures", shared.textures.size()) +
      Line("bounds", BoundsText(scene.root.bounds)) +
      Line("camera", "at " + WithDecimals(DecimalsFor(scene.root.bounds), scene.camera.eye) + ", towards " +
                         WithDecimals(3, scene.camera.towards) + ", half angle " + Fixed(scene.camera.xfov, 3) +
                         " rad, " + Fixed(scene.camera.Fov(), 1) + " degrees in all" + ProjectionText(scene.camera) +
                         (scene.has_default_camera ? " (the default: the scene names none)" : "")) +
      LightLines(world, settings.mode);
  const double megabytes = 1e-6 * static_cast<double>(Memory(world, shared, settings));
  return text + Line("memory", "about " + Fixed(megabytes, 1) + " MB with the image");
}

}  // namespace ray

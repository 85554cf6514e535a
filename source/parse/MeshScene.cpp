#include "source/parse/MeshScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "R1/Elementary.h"
#include "R3/ShapeKind.h"
#include "source/parse/Model.h"
#include "source/parse/SceneBuilder.h"
#include "source/parse/Text.h"
#include "source/scene/Light.h"
#include "source/text/LowerCase.h"

namespace ray {
namespace {

/// The orientation of a mesh: its up direction, and the direction of its front.
struct Stand {
  R3::Vector up, front;
};

/// Programs that write STL, for printers and machines, have z up; others have y up.
Stand StandOf(const std::string& file) {
  const bool is_stl = LowerCase(std::filesystem::path(file).extension().string()) == ".stl";
  return is_stl ? Stand{{0, 0, 1}, {0, -1, 0}} : Stand{{0, 1, 0}, {0, 0, 1}};
}

constexpr double to_the_side = 0.6, above = 0.24;  // camera position in radians, to the side of the front and above it
constexpr double half_angle = 0.32;
constexpr double filled = 0.92;  // share of the image's width or height

/// Returns a camera that shows the whole model, which is inside the box, in three-quarter view, for images with that
/// aspect.
Camera CameraOn(const Assets::Model& model, const R3::Box& box, const Stand& stand, double aspect) {
  const R3::Vector side = Cross(stand.up, stand.front);
  const R3::Vector level = R1::Cos(to_the_side) * stand.front + R1::Sin(to_the_side) * side;
  const R3::Vector towards = -(R1::Cos(above) * level + R1::Sin(above) * stand.up);
  const R3::Point center = box.Center();
  Camera camera = Aim(center, towards, stand.up).camera;
  camera.xfov = half_angle;
  const double half_width = filled * camera.HalfWidth(), half_height = half_width / aspect;
  double distance = 0;
  for (const Assets::Model::Part& part : model.parts)
    for (int i = 0; i < part.mesh.mesh->Elements(); ++i)
      for (const R3::Point& p : part.mesh.mesh->Corners(i)) {
        const R3::Vector corner = p - center;
        const double in_front = Dot(corner, camera.towards);
        distance = std::max({distance, std::abs(Dot(corner, camera.right)) / half_width - in_front,
                             std::abs(Dot(corner, camera.up)) / half_height - in_front});
      }
  camera.eye = center - distance * camera.towards;
  camera.near = 0.01 * box.Radius();
  camera.far = 100 * box.Radius();
  return camera;
}

void AddLight(Scene& scene, const R2::Color& color, const R3::Vector& along) {
  const std::array arguments{color.r, color.g, color.b, along.x, along.y, along.z};
  scene.lights.push_back(FindLightKind("dir_light")->make(arguments));
}

/// Adds a sun above and in front of the model, to the left as seen by the camera, and weaker light from the other side.
void Light(Scene& scene, const Camera& camera, const Stand& stand) {
  scene.background = {0.62, 0.72, 0.86};
  scene.ambient = {0.22, 0.24, 0.27};
  AddLight(scene, {0.9, 0.88, 0.84}, 0.9 * camera.right + 1.1 * camera.towards - 1.3 * stand.up);
  AddLight(scene, {0.2, 0.21, 0.23}, -camera.right + 0.5 * camera.towards - 0.5 * stand.up);
}

int AddDiffuse(Scene& scene, const R2::Color& kd) {
  scene.materials.push_back(DiffuseMaterial(kd));
  return static_cast<int>(scene.materials.size()) - 1;
}

/// Returns a plane below the box, at a distance from faces at its bottom.
Node Ground(Scene& scene, const R3::Box& box, const Stand& stand) {
  constexpr double gap = 1e-3;  // of the model's radius: less than a pixel out of a thousand
  const R3::Point p = box.low - gap * box.Radius() * stand.up;
  const R3::Vector n = stand.up;
  Node node;
  node.material = AddDiffuse(scene, {0.5, 0.49, 0.45});
  node.shape = R3::MakeShape("plane", {p.x, p.y, p.z, n.x, n.y, n.z});
  SetBounds(node);
  return node;
}

void AddModel(SceneBuilder& builder, const FoundFile& file, const std::shared_ptr<const Assets::Model>& model,
              double aspect) {
  Scene& scene = builder.scene;
  const Stand stand = StandOf(file.shown);
  R3::Box box;
  for (Node& node : builder.NodesOf(model, AddDiffuse(scene, default_gray))) {
    box.Extend(node.bounds);
    builder.Add(std::move(node));
  }
  if (box.IsEmpty() || !(box.Radius() > 0)) return;
  builder.Add(Ground(scene, box, stand));
  scene.camera = CameraOn(*model, box, stand, aspect);
  Light(scene, scene.camera, stand);
  builder.has_camera = builder.has_light = true;
  // Programs triangulate models arbitrarily; that must not change the brightness of emissive parts.
  const bool shines = std::ranges::any_of(scene.materials, [](const Material& m) { return !IsBlack(m.emission); });
  if (shines) scene.settings.push_back({"emissive_meshes", "whole", "a mesh alone"});
}

}  // namespace

Scene ReadMeshScene(const Files& files, const ParseOptions& options, Assets& assets, Report& report) {
  SceneBuilder builder;
  builder.scene.files.push_back(files.TopName());
  try {
    const FoundFile file = files.Top();
    const auto model = assets.ModelOf(file, {Assets::Shading::Normals::of_file_or_groups});
    AddModel(builder, file, model, options.aspect);
  } catch (const FileError& error) {
    report.Error(ErrorIn(files.TopName(), error.message, error.hint));
  } catch (const SceneError& error) {
    report.Error(error);
  }
  auto& names = builder.scene.files;
  for (const std::string& name : assets.FilesRead())
    if (name != files.TopName()) names.push_back(name);
  return builder.Finish();
}

}  // namespace ray

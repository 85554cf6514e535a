// A mirrored smooth mesh, whose triangles have the opposite orientation, compared with the original: the same image,
// bit for bit, for everything that depends on the front of a surface.
#include <gtest/gtest.h>

#include <string>

#include "source/text/EnumNames.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

/// Returns an octahedron with a texture, its normals outward.
std::string Octahedron(bool is_mirrored) {
  std::string text;
  const char* const corners[] = {"1 0 0", "-1 0 0", "0 1 0", "0 -1 0", "0 0 1", "0 0 -1"};
  for (const char* corner : corners) text += std::string("v ") + corner + "\nvn " + corner + "\n";
  text += "vt 0 0\nvt 1 0\nvt 0 1\n";
  const int faces[][3] = {{5, 1, 3}, {5, 3, 2}, {5, 2, 4}, {5, 4, 1}, {6, 3, 1}, {6, 2, 3}, {6, 4, 2}, {6, 1, 4}};
  for (const auto& face : faces) {
    text += "f";
    for (const int k : {0, is_mirrored ? 2 : 1, is_mirrored ? 1 : 2}) {
      const std::string corner = std::to_string(face[k]);
      text += " " + corner + "/" + std::to_string(k + 1) + "/" + corner;
    }
    text += "\n";
  }
  return text;
}

R2::Image Shown(const std::string& material, RenderMode mode, bool is_mirrored) {
  const TemporaryFolder folder;
  WriteFile(folder / "a.obj", Octahedron(is_mirrored));
  std::filesystem::copy_file(project::Root() / "scenes/textures/checker.png", folder / "t.png");
  const std::string scene =
      "camera .3 .4 5  0 0 -1  0 1 0  .3  .01 100\nbackground .2 .3 .5\npoint_light 1 1 1  2 3 5  1 0 0\n"
      "material 0 0 0  .7 .7 .7  0 0 0  0 0 0  0 0 0  1 1 t.png\nbox 0  -3 -3 -3  3 3 -2\n" +
      material + "\nbegin 1  1 .2 0 0  0 1 0 .1  0 0 1 0  0 0 0 1  mesh -1 a.obj smooth end\n";
  const project::Stage stage(Parse(WriteFile(folder / "a.scn", scene), {}).scene);
  RenderSettings settings = project::Sized(24);
  settings.samples = 4;
  settings.trace.max_depth = 8;
  settings.trace.fresnel = true;
  settings.mode = mode;
  return project::Render(stage, settings).image;
}

TEST(MirroredMesh, HasTheImageOfTheOriginal) {
  const std::pair<const char*, const char*> materials[] = {
      {"diffuse", "material 0 0 0  .7 .7 .7  .2 .2 .2  0 0 0  0 0 0  20 1 0"},
      {"tinted glass", "material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  1 1.5 0\nabsorb 1  .2 .5 .9"},
      {"bumps", "material 0 0 0  .7 .7 .7  .2 .2 .2  0 0 0  0 0 0  20 1 0\nbump 1  t.png .05"},
      {"a normal map", "material 0 0 0  .7 .7 .7  .2 .2 .2  0 0 0  0 0 0  20 1 0\nnormal_map 1  t.png"},
      {"a tinted lamp", "material 0 0 0  .1 .1 .1  0 0 0  .5 .5 .5  1 1 1  1 1.2 0\nabsorb 1  .2 .5 .9"}};
  for (const auto& [name, material] : materials)
    for (const RenderMode mode : {RenderMode::whitted, RenderMode::path, RenderMode::normal, RenderMode::uv})
      EXPECT_TRUE(Shown(material, mode, true) == Shown(material, mode, false)) << name << ", " << NameOf(mode);
}

}  // namespace
}  // namespace ray::testing

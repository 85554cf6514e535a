// Scenes written as .scn are the same scenes when they are read again.
#include "source/parse/scn/ScnText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "R3/Mesh.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/text/NumberText.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

/// Returns the text of a scene as it would be in a folder, with its meshes next to it.
std::string WrittenTo(const Folder& folder, const std::string& name, const Scene& scene) {
  const ScnText text = WriteScn(scene, folder / name);
  for (const ScnText::Mesh& mesh : text.meshes) folder.Write(mesh.name, mesh.text);
  folder.Write(name, text.text);
  return text.text;
}

/// Returns the image that raypro would render, with the scene's settings, but small.
R2::Image ImageOf(Scene scene) {
  RenderOptions options =
      ReadCommandLine(Program::raypro, std::vector<std::string>{"in.scn", "out.pfm", "-width", "24", "-height", "18"});
  options = WithSettingsOf(scene, options);
  return project::Render(project::Stage(std::move(scene)), options.render).image;
}

/// Returns every scene and mesh below a folder, which may be missing.
std::vector<fs::path> ScenesBelow(const fs::path& folder) {
  std::vector<fs::path> scenes;
  const std::set<std::string> extensions{".scn", ".yaml", ".yml", ".json", ".txt",
                                         ".obj", ".off",  ".ply", ".stl",  ".ray"};
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if (extensions.contains(entry.path().extension().string())) scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

std::optional<Scene> ReadIfItIsOne(const fs::path& file, const ParseOptions& options) {
  try {
    return Parse(file, options).scene;
  } catch (const SceneErrors&) {
    return {};
  }
}

void ExpectTheSameAgain(const fs::path& file) {
  ParseOptions options;
  options.allowed_folders = {"/"};
  std::optional<Scene> scene = ReadIfItIsOne(file, options);
  if (!scene) return;
  const Folder folder;
  const std::string text = WrittenTo(folder, "once.scn", *scene);
  Scene again = Parse(folder / "once.scn", options).scene;
  EXPECT_EQ(WriteScn(again, folder / "twice.scn").text, text) << file;
  EXPECT_TRUE(ImageOf(std::move(again)) == ImageOf(std::move(*scene))) << file;
}

TEST(ScnText, OfOurScenesGivesTheSameImageAndTextAgain) {
  for (const char* folder :
       {"scenes", "writeup/scenes", "tests/source/parse/models", "tests/source/parse/meshes/files"})
    for (const fs::path& file : ScenesBelow(project::Root() / folder)) ExpectTheSameAgain(file);
}

TEST(ScnText, OfEveryCourseSceneGivesTheSameImage) {
  std::vector<fs::path> files;
  for (const char* course : {"scenes-cos426", "scenes-groningen", "scenes-cs315", "scenes-comp30019"}) {
    const auto more = ScenesBelow(project::Shared() / course);
    files.insert(files.end(), more.begin(), more.end());
  }
  if (files.empty()) GTEST_SKIP() << "the scenes are not beside this checkout";
  for (const fs::path& file : files) ExpectTheSameAgain(file);
}

TEST(ScnText, OfShapesAndLightsKeepsTheirOriginalNumbers) {
  for (const R3::ShapeKind* kind : R3::ShapeKinds()) {
    const auto made = kind->make(kind->example)->MadeFrom();
    ASSERT_TRUE(made) << kind->name;
    EXPECT_EQ(made->kind, std::string(kind->name));
    EXPECT_EQ(made->arguments, kind->example) << kind->name;
  }
  for (const LightKind* kind : LightKinds()) {
    const R3::Recipe made = kind->make(kind->example)->MadeFrom();
    EXPECT_EQ(made.kind, std::string(kind->name));
    EXPECT_EQ(made.arguments, kind->example) << kind->name;
  }
}

TEST(ScnText, ExpressesEverythingThatTheLanguageSupports) {
  const Folder folder;
  const std::string text =
      "set max_depth 3\n"
      "set zbuffer_range 1 20\n"
      "camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100 view 1.5 0.25 -0.5\n"
      "background 0.1 0.2 0.3\n"
      "ambient 0.3 0.2 0.1\n"
      "shadow_bias 0.001\n"
      "point_light 1 1 1 0 3 5 1 0 0\n"
      "material 0 0 0 1 0 0 0.5 0.5 0.5 0 0 0 0 0 0 10 1.5 0\n"
      "mirror 0 0.1 0.2 0.3\n"
      "absorb 0 0.5 0.25 0.125\n"
      "coat 0 1.25\n"
      "texture_ambient 0\n"
      "texture_scale 0 2 0.5\n"
      "texture_project 0\n"
      "one_sided 0\n"
      "flat_color 0 0.75 0.5 0.25\n"
      "gloss 0 20.5 16\n"
      "sphere -1 0 0 0 1\n"
      "begin 0 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n"
      "  motion 0.5 0 0\n"
      "  begin -1 2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1\n"
      "    plane -1 0 -1 0 0 3 0\n"
      "    tri 0 0 0 0 1 0 0 0 1 0\n"
      "  end\n"
      "  line -1 0 0 0 1 1 1\n"
      "end\n";
  folder.Write("in.scn", text);
  EXPECT_EQ(WriteScn(Parse(folder / "in.scn", {}).scene, folder / "out.scn").text, text);
}

TEST(ScnText, IncludesInGroupsKeepTheInheritedDefaultMaterial) {
  const Folder folder;
  folder.Write("part.scn", "sphere -1 0 0 0 1\n");
  folder.Write("in.scn", red + "begin 0" + identity + "include part.scn\nend\n");
  const Scene scene = Parse(folder / "in.scn", {}).scene;
  WrittenTo(folder, "out.scn", scene);
  const Scene again = Parse(folder / "out.scn", {}).scene;
  const Node& sphere = again.root.children.at(0).children.at(0);
  ASSERT_GT(sphere.material, 0);
  EXPECT_EQ(again.materials[static_cast<std::size_t>(sphere.material)].kd, Material().kd);
}

TEST(ScnText, ASceneWithoutLightsGetsNoneByDefault) {
  const Folder folder;
  WrittenTo(folder, "out.scn", Scene{});
  const Scene again = Parse(folder / "out.scn", {}).scene;
  ASSERT_EQ(again.lights.size(), 1u);
  EXPECT_TRUE(again.lights[0]->IsBlack());
}

R3::MeshData Fan(bool has_normals) {
  R3::MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0.3}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  data.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1. / 3}};
  if (has_normals) data.normals = {{0.1, 0.2, 1}, {-0.3, 0.4, 1}, {0, 0, 0}, {0.7, -0.1, 0.3}};
  return data;
}

Scene SceneOf(std::shared_ptr<const R3::Mesh> mesh, Material material = {}) {
  Scene scene;
  scene.materials.push_back(std::move(material));
  Node node;
  node.shape = std::move(mesh);
  node.material = 1;
  SetBounds(node);
  scene.root.children.push_back(std::move(node));
  return scene;
}

TEST(ScnText, AMeshWithoutAFileIsTriangles) {
  const ScnText text = WriteScn(SceneOf(std::make_shared<const R3::Mesh>(Fan(false))), "/nowhere/out.scn");
  EXPECT_TRUE(text.meshes.empty());
  EXPECT_TRUE(text.text.ends_with("tri 0 0 0 0 1 0 0 1 1 0.1\ntri 0 0 0 0 1 1 0.1 0 1 0.3\n")) << text.text;
}

// As triangles they would have other texture coordinates, which -mode uv shows.
TEST(ScnText, QuadsAndPolygonsStayUnchanged) {
  const std::string lines =
      "quad 0 0 0 0 1 0 0 1 1 0 0 1 0\npolygon 0 4 0 0 0 2 -1 0 0.5 0 0 2 1 0\npolygon 0 3 0 0 0 1 0 0 0 1 0\n";
  const std::string lamp = "material 0 0 0  1 1 1  0 0 0  0 0 0  1 1 1  1 1 0\n";
  const ScnText text = WriteScn(ParseText(lamp + lines).scene, "/nowhere/out.scn");
  EXPECT_TRUE(text.meshes.empty());
  EXPECT_TRUE(text.text.ends_with(lines)) << text.text;
}

// In mode whitted a quad or polygon is one lamp, however many triangles it is split into.
TEST(ScnText, AnEmissivePolygonStaysOneLampWhateverItsCorners) {
  const std::string lamp = "material 0 0 0  1 1 1  0 0 0  0 0 0  1 1 1  1 1 0\n";
  std::string ring = "polygon 0 200", one_corner_twice = "polygon 0 5 0 0 0 1 0 0 1 0 0 1 1 0 0 1 0\n";
  for (int i = 0; i < 200; ++i) {
    const double angle = i * std::numbers::pi / 100;
    ring += " " + ToText(std::cos(angle)) + " " + ToText(std::sin(angle)) + " 0";
  }
  const ScnText text = WriteScn(ParseText(lamp + ring + "\n" + one_corner_twice).scene, "/nowhere/out.scn");
  EXPECT_TRUE(text.warnings.empty());
  EXPECT_TRUE(text.text.ends_with(ring + "\n" + one_corner_twice)) << text.text;
  EXPECT_EQ(WriteScn(ParseText("material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 0\n" + ring).scene, "/nowhere/out.scn")
                .meshes.size(),
            1u)
      << "a surface that is not a lamp adds no corners";
}

TEST(ScnText, AMirroredImageStaysMirrored) {
  Scene scene;
  scene.camera = Aim({1, 2, -9}, {0, 0, 1}, {0, 1, 0}).camera;
  scene.camera.shift = {0.5, 0};
  scene.camera.right = -scene.camera.right;
  const Folder folder;
  const std::string text = WrittenTo(folder, "out.scn", scene);
  EXPECT_TRUE(Contains(text, " view 0 0.5 0 mirrored\n")) << text;
  EXPECT_EQ(Parse(folder / "out.scn", {}).scene.camera.right, scene.camera.right);
}

TEST(ScnText, SmoothOrEmissiveMeshesWithoutAFileAreWrittenOnce) {
  Material lamp;
  lamp.emission = {1, 1, 1};
  EXPECT_EQ(WriteScn(SceneOf(std::make_shared<const R3::Mesh>(Fan(false)), lamp), "/nowhere/a.scn").meshes.size(), 1u);
  const auto smooth = std::make_shared<const R3::Mesh>(Fan(true), true);
  Scene twice = SceneOf(smooth);
  twice.root.children.push_back(std::move(SceneOf(smooth).root.children[0]));
  const ScnText text = WriteScn(twice, "/nowhere/a.scn");
  ASSERT_EQ(text.meshes.size(), 1u);
  EXPECT_EQ(text.meshes[0].name, "a-1.obj");
  EXPECT_TRUE(text.text.ends_with("mesh 0 a-1.obj smooth\nmesh 0 a-1.obj smooth\n")) << text.text;
}

TEST(ScnText, FilesAreNamedRelativeToTheTextsFolder) {
  const Folder folder;
  folder.Write("models/one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.Write("in.scn", "mesh -1 models/one.off\n");
  fs::create_directories(folder / "copies");
  const Scene scene = Parse(folder / "in.scn", {}).scene;
  const ScnText beside = WriteScn(scene, folder / "out.scn"), below = WriteScn(scene, folder / "copies/out.scn");
  EXPECT_TRUE(Contains(beside.text, "mesh -1 models/one.off\n")) << beside.text;
  EXPECT_TRUE(beside.other_folders.empty());
  EXPECT_TRUE(Contains(below.text, "mesh -1 ../models/one.off\n")) << below.text;
  EXPECT_EQ(below.other_folders, std::set<std::string>{(folder / "models").string()});
}

TEST(ScnText, NamesWithAnyCharacterAreReadBack) {
  for (const char* name : {"#cube.off", "1#cube.off", "-2.5e3#x.off", "cube#1.off", "a mesh.off", "\"quoted\".off",
                           "tab\there.off", "two\nlines.off", "cr\r.off", "back\\slash.off", " \\\" .off", "-1.off"}) {
    const Folder folder;
    folder.Write(name, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    const ScnText text = WriteScn(Parse(folder / name, {}).scene, folder / "out.scn");
    EXPECT_TRUE(text.warnings.empty());
    EXPECT_TRUE(text.meshes.empty());
    const Scene again = Parse(folder.Write("out.scn", text.text), {}).scene;
    EXPECT_EQ(again.files.back(), (folder / name).string());
    EXPECT_EQ(WriteScn(again, folder / "out.scn").text, text.text);
  }
}

TEST(ScnText, ATextureCalled0IsReadBackAsOne) {
  const Folder folder;
  folder.Write("0", "P3 1 1 255 255 0 0 ");
  folder.Write("in.scn", "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 10 1 \"0\"\nsphere 0 0 0 0 1\n");
  const std::string text = WriteScn(Parse(folder / "in.scn", {}).scene, folder / "out.scn").text;
  EXPECT_TRUE(Parse(folder.Write("out.scn", text), {}).scene.materials.at(1).texture) << text;
}

TEST(ScnText, NamesTheMapsOfAMaterial) {
  const Folder folder;
  folder.Write("t.ppm", "P3 1 1 255 255 0 0 ");
  const std::string maps = "specular_map 0 t.ppm\nnormal_map 0 t.ppm\nbump 0 t.ppm 0.5\n";
  folder.Write("in.scn", "material 0 0 0 1 1 1 .5 .5 .5 0 0 0 0 0 0 10 1 t.ppm\n" + maps + "sphere 0 0 0 0 1\n");
  const std::string text = WriteScn(Parse(folder / "in.scn", {}).scene, folder / "out.scn").text;
  EXPECT_TRUE(Contains(text, maps)) << text;
}

TEST(ScnText, MeshesNextToASceneNamedWithBlanksAreFound) {
  const Folder folder;
  folder.Write("in.scn", "material 0 0 0 1 1 1 0 0 0 0 0 0 1 1 1 10 1 0\nmesh 0 m.off smooth\n");
  folder.Write("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  Scene scene = Parse(folder / "in.scn", {}).scene;
  R3::MeshData data = dynamic_cast<const R3::Mesh&>(*scene.root.children.at(0).shape).Data();
  scene.root.children[0].shape = std::make_shared<const R3::Mesh>(std::move(data));  // of no file
  EXPECT_TRUE(Contains(WrittenTo(folder, "my scene.scn", scene), "mesh 0 \"my scene-1.obj\""));
  EXPECT_NO_THROW(Parse(folder / "my scene.scn", {}));
}

TEST(ScnText, GroupsAHundredThousandDeepAreWritten) {
  constexpr int depth = 100'000;
  std::string text;
  for (int i = 0; i < depth; ++i) text += "begin -1" + identity;
  for (int i = 0; i < depth; ++i) text += "end\n";
  const std::string written = WriteScn(ParseText(text).scene, "/nowhere/out.scn").text;
  EXPECT_TRUE(written.ends_with("  end\nend\n"));
}

TEST(ObjText, ReadsBackAsTheSameMeshToTheBit) {
  for (const bool smooth : {false, true}) {
    const R3::Mesh mesh(Fan(smooth), smooth);
    Report report;
    const R3::Mesh again(MeshFormatForName("a.obj")->read(Text{"a.obj", ObjText(mesh)}, report).data, smooth);
    EXPECT_EQ(again.Data().positions, mesh.Data().positions);
    EXPECT_EQ(again.Data().triangles, mesh.Data().triangles);
    EXPECT_EQ(again.Data().uvs, mesh.Data().uvs);
    EXPECT_EQ(again.Data().normals, mesh.Data().normals);
  }
}

}  // namespace
}  // namespace ray

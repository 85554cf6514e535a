// Files with the names of meshes that are not meshes. files/looks/make.sh wrote them with other programs.

#include <gtest/gtest.h>

#include <filesystem>

#include "source/parse/meshes/MeshFormat.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

std::string BytesOf(const std::string& name) {
  return project::BytesOf(project::Root() / "tests/source/parse/meshes/files" / name);
}

std::string ErrorOf(const MeshFormat& format, const std::string& bytes) {
  Report report;
  try {
    format.read({std::string("a") + format.extension, bytes}, report);
    return "(none)";
  } catch (const SceneError& error) {
    return error.message + (error.hint.empty() ? "" : "; " + error.hint);
  }
}

TEST(Looks, NonMeshFilesAreErrors) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(project::Root() / "tests/source/parse/meshes/files/looks")) {
    const std::string name = entry.path().filename().string(), bytes = BytesOf("looks/" + name);
    ASSERT_FALSE(bytes.empty()) << name;
    if (entry.path().extension() == ".sh") continue;
    ++files;
    for (const MeshFormat* format : MeshFormats()) EXPECT_NE(ErrorOf(*format, bytes), "(none)") << name << format->extension;
  }
  EXPECT_EQ(files, 16);
}

TEST(Looks, AMeshUnderTheExtensionOfAnotherIsAnError) {
  EXPECT_NE(ErrorOf(*MeshFormatForName("a.obj"), BytesOf("wedges.ply")), "(none)");
  EXPECT_NE(ErrorOf(*MeshFormatForName("a.ply"), BytesOf("pairs.off")), "(none)");
  EXPECT_NE(ErrorOf(*MeshFormatForName("a.off"), BytesOf("capitals.stl")), "(none)");
}

TEST(Looks, AnObjFileWithoutVerticesIsAnError) {
  Report report;
  const auto error = [&](const std::string& name, const std::string& bytes) {
    try {
      MeshFormatForName(name)->read({name, bytes}, report);
      return std::string("(none)");
    } catch (const SceneError& e) {
      return e.Format();
    }
  };
  EXPECT_EQ(error("a.obj", "A cube.\n\nIt has 6 faces.\n"),
            "a.obj:1:1: error: not one line defines a vertex in OBJ; unknown statement 'A'\n"
            "    1 | A cube.\n      | ^");
  EXPECT_EQ(error("a.ray", "A cube.\n"),
            "a.ray:1:1: error: a .ray file contains commands such as #vertex; this one begins with 'A'\n"
            "    1 | A cube.\n      | ^");
  EXPECT_EQ(error("a.ray", ""), "(none)");
  EXPECT_EQ(error("a.obj", "g empty\n"), "(none)");
}

TEST(Looks, InvisibleStatementsOfObjAreCounted) {
  Report report;
  const std::string text =
      "o a\ng b\ns off\nv 0 0 0\nv 1 0 0\nv 0 1 0\nfo 1 2 3\nl 1 2\nl 2 3\np 1\ncstype bezier\ncurv 0 1 1 2\nend\n"
      "vertex 1\nfoo 2\n";
  const R3::MeshData data = MeshFormatForName("a.obj")->read({"a.obj", text}, report).data;
  EXPECT_EQ(data.triangles.size(), 1u);
  EXPECT_EQ(report.Warnings(),
            (std::vector<std::string>{
                "a.obj:8:1: warning: 3 statements of lines or points skipped, the first of them here",
                "a.obj:11:1: warning: 3 statements of curves or surfaces skipped, the first of them here",
                "a.obj:14:1: warning: 2 unknown statements skipped, the first of them here"}));
}

}  // namespace
}  // namespace ray

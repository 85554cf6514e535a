// Files that are found under the names of meshes and are none. files/looks/make.sh wrote them with other programs.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "source/parse/meshes/MeshFormat.h"
#include "source/text/FileLook.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

std::string BytesOf(const std::string& name) {
  std::ostringstream bytes;
  bytes << std::ifstream(ProjectRoot() / "tests/source/parse/meshes/files" / name, std::ios::binary).rdbuf();
  return bytes.str();
}

std::string ErrorOf(const MeshFormat& format, const std::string& bytes) {
  Report report;
  try {
    ReadMeshFile(format, {std::string("a") + format.extension, bytes}, report);
    return "(none)";
  } catch (const SceneError& error) {
    return error.message + (error.hint.empty() ? "" : "; " + error.hint);
  }
}

// A mistake in line 1 of what is no mesh, or a mesh without faces, would say nothing about what is wrong.
TEST(Looks, NonMeshFilesAreIdentified) {
  const std::map<std::string, std::string> looks{
      {"coff.o", "a COFF object file"},
      {"coff32.o", "a COFF object file"},
      {"elf.o", "an ELF object file or program"},
      {"elf32.o", "an ELF object file or program"},
      {"library.a", "a library of object files"},
      {"utf16", "UTF-16 text"},
      {"utf16le", "UTF-16 text"},
      {"utf16be", "UTF-16 text"},
      {"mesh.gz", "a file compressed by gzip"},
      {"mesh.bz2", "a file compressed by bzip2"},
      {"mesh.xz", "a file compressed by xz"},
      {"mesh.zip", "a ZIP archive"},
      {"lfs", "a Git LFS pointer"},
      {"page", "a web page"},
      {"collada", "an XML document"},
      {"json", "a JSON document"},
  };
  for (const auto& [name, what] : looks) {
    const std::string bytes = BytesOf("looks/" + name);
    ASSERT_FALSE(bytes.empty()) << name;
    for (const MeshFormat* format : MeshFormats()) {
      const std::string expected = "this looks like " + what + " rather than " + format->extension + " data";
      EXPECT_TRUE(ErrorOf(*format, bytes).starts_with(expected)) << name << ": " << ErrorOf(*format, bytes);
    }
  }
}

TEST(Looks, TheHintSaysWhatToDo) {
  const MeshFormat& obj = *MeshFormatForName("a.obj");
  EXPECT_TRUE(ErrorOf(obj, BytesOf("looks/lfs")).ends_with("; 'git lfs pull' fetches the file itself"));
  EXPECT_TRUE(ErrorOf(obj, BytesOf("looks/utf16")).ends_with("; save it as UTF-8"));
  EXPECT_TRUE(ErrorOf(obj, BytesOf("looks/mesh.zip")).ends_with("; unpack it first"));
}

TEST(Looks, AMeshUnderTheExtensionOfAnotherIsTold) {
  EXPECT_EQ(ErrorOf(*MeshFormatForName("a.obj"), BytesOf("wedges.ply")),
            "this looks like a PLY mesh rather than .obj data; give it the extension .ply");
  EXPECT_EQ(ErrorOf(*MeshFormatForName("a.ply"), BytesOf("pairs.off")),
            "this looks like an OFF mesh rather than .ply data; give it the extension .off");
  EXPECT_EQ(ErrorOf(*MeshFormatForName("a.off"), BytesOf("capitals.stl")),
            "this looks like an STL mesh rather than .off data; give it the extension .stl");
}

// What a file looks like matters only where it cannot be read.
TEST(Looks, WhatIsReadIsNotJudgedByItsLook) {
  const std::string header = "MZ" + std::string(78, ' ') + std::string("\1\0\0\0", 4);
  std::string triangle(50, '\0');
  triangle[12 + 12 + 2] = triangle[12 + 24 + 6] = '\x80', triangle[12 + 12 + 3] = triangle[12 + 24 + 7] = '\x3F';
  EXPECT_EQ(ErrorOf(*MeshFormatForName("a.stl"), header + triangle), "(none)");
  EXPECT_EQ(ErrorOf(*MeshFormatForName("a.stl"), "solid x\nendsolid x\n"), "(none)");
  EXPECT_TRUE(ErrorOf(*MeshFormatForName("a.stl"), "solid x\nfacet\n").starts_with("the file ends before normal"));
  EXPECT_EQ(ErrorOf(*MeshFormatForName("a.obj"), "# nothing\n"), "(none)");
  EXPECT_EQ(LookOf("").what, nullptr);
  EXPECT_EQ(LookOf("v 0 0 0\n").what, nullptr);
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
            "a.ray:1:1: error: a .ray file holds commands such as #vertex; this one begins with 'A'\n"
            "    1 | A cube.\n      | ^");
  EXPECT_EQ(error("a.ray", ""), "(none)");
  EXPECT_EQ(error("a.obj", "g empty\n"), "(none)");
}

TEST(Looks, StatementsOfObjThatAreNotSeenAreCounted) {
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

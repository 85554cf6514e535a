// Numbers in excess of the declarations in a mesh file. Dropping them would shift everything that follows, and only
// half a mesh would be drawn.

#include <gtest/gtest.h>

#include <array>

#include "tests/source/parse/Folder.h"
#include "tests/source/parse/ReadMesh.h"

namespace ray {
namespace {

const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Surplus, EveryFormatReportsNonFiniteNumbersWithTheirPlace) {
  for (const std::string word : {"1.#QNAN", "-1.#IND", "1.#INF00", "1.#J", "nan", "-inf", "-nan(ind)"}) {
    const std::string got = " must be a finite number, got '" + word + "'";
    EXPECT_EQ(MeshErrorOf("a.off", "OFF\n3 1 0\n0 0 0\n1 " + word + " 0\n0 1 0\n3 0 1 2\n"),
              "a.off:4:3: y of vertex 1" + got);
    EXPECT_EQ(MeshErrorOf("a.obj", "v 0 0 0\nv 1 " + word + " 0\nv 0 1 0\nf 1 2 3\n"),
              "a.obj:2:5: y of vertex 2" + got);
    EXPECT_EQ(MeshErrorOf("a.ray", "#vertex 1 " + word + " 0 0 0 1 0 0\n"), "a.ray:1:11: y of vertex 0" + got);
    EXPECT_EQ(MeshErrorOf("a.stl", "solid\nfacet normal 0 0 1 outer loop\nvertex 1 " + word + " 0\n"),
              "a.stl:3:10: y of a corner of face 0" + got);
    EXPECT_EQ(MeshErrorOf("a.ply", ply_header + "0 0 0\n1 " + word + " 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"),
              "a.ply:11:3: vertex 1: y must be finite and must not exceed 1e150 in magnitude");
    EXPECT_TRUE(Contains(ReportOf("sphere -1 0 0 0 " + word + "\n"), "scene.scn:1:17: error: radius" + got)) << word;
  }
  EXPECT_EQ(ReportOf("sphere -1 0 0 0 1#comment\n"), "");
}

TEST(Surplus, ExtraOffVertexNumbersAreWarningsWhenNothingIsMissing) {
  const std::string faces = "3 0 1 2\n3 0 2 3\n";
  const auto read =
      MeshOfBytes("a.off", "OFF\n4 2 0\n0 0 0 .5 .5 1\n1 0 0 .5 .5 1\n1 1 0 .5 .5 1\n0 1 0 .5 .5 1\n" + faces);
  EXPECT_EQ(read.data.triangles.size(), 2u);
  EXPECT_EQ(read.data.positions.at(3), (R3::Point{0, 1, 0}));
  EXPECT_EQ(read.warnings.size(), 1u);
}

TEST(Surplus, ExtraOffVertexNumbersAreErrorsWhenFacesAreMissing) {
  // Two lines of vertices would count as one vertex each, and the rest would be half the faces.
  const std::string vertices = "0 0 0 7\n1 0 0 7\n1 1 0 7\n0 1 0 7\n";
  const std::string hint = "the header declares 3 numbers for each vertex, but there are lines with more";
  EXPECT_EQ(MeshErrorOf("a.off", "OFF\n4 2 0\n" + vertices + "3 0 1 2\n"),
            "a.off:6:1: face 0 has fewer than 3 corners; " + hint)
      << "read number by number, four vertices end with the third line";
  EXPECT_TRUE(Contains(MeshErrorOf("a.off", "OFF\n4 2 0\n" + vertices + "3 0 1 2\n3 0 2 4.5\n"), hint));
  EXPECT_EQ(MeshErrorOf("a.off", "OFF\n4 2 0\n" + vertices + "3 0 1 2\n\n2 0 2\n"),
            "a.off:9:1: face 1 has fewer than 3 corners; " + hint);
  EXPECT_EQ(MeshErrorOf("a.off", "OFF\n4 1 0\n" + vertices + "3 0 1 2\n3 0 2 3\n"),
            "a.off:8:1: the file has more data than the header declares; " + hint);
  EXPECT_EQ(MeshErrorOf("a.off", "OFF\n3 2 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2\n"),
            "a.off:5:7: the header declares 2 faces, but the file has 1; " + hint);
}

TEST(Surplus, TwoOffFacesOnALineAreAnError) {
  const std::string vertices = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const std::string lacks =
      "the header declares 2 faces, but the file has 1; numbers after a face on its line are read as its color";
  EXPECT_EQ(MeshErrorOf("a.off", vertices + "3 0 1 2  3 0 2 3\n"), "a.off:7:10: " + lacks);
  EXPECT_EQ(MeshErrorOf("a.off", vertices + "4 0 1 2 3  4 0 1 2 3\n"), "a.off:7:12: " + lacks);
  EXPECT_EQ(MeshErrorOf("a.off", vertices + "3 0 1 2  255 0 0 255\n"), "(none)")
      << "the header's mistake, and a warning";
  const auto read = MeshOfBytes("a.off", vertices + "3 0 1 2 255 0 0 255 9\n3 0 2 3 255 0 0\n");
  EXPECT_EQ(read.data.triangles.size(), 2u);
  EXPECT_EQ(read.warnings,
            std::vector<std::string>{
                "a.off:7:9: warning: 1 face has ignored numbers after its corners, more than a color has"});
}

TEST(Surplus, ExtraPlyVertexNumbersAreErrors) {
  EXPECT_EQ(MeshErrorOf("a.ply", ply_header + "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n3 0 1 2\n3 0 2 3\n"),
            "a.ply:10:7: vertex 0 has more numbers than the header declares; declared: x, y, z");
  EXPECT_EQ(MeshErrorOf("a.ply", ply_header + "0 0 0\n1 0 0\n1 1 0 .5 .5\n0 1 0\n3 0 1 2\n3 0 2 3\n"),
            "a.ply:12:7: vertex 2 has more numbers than the header declares; declared: x, y, z");
  // With a face too few, four vertices end with the third line.
  EXPECT_EQ(MeshErrorOf("a.ply", ply_header + "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n3 0 1 2\n"),
            "a.ply:13:1: face 0: has fewer than 3 corners; there are lines with more numbers than the header declares");
  EXPECT_EQ(MeshErrorOf("a.ply", ply_header + "0 0 0 9\n1 0 0 9\n1 1 0 9\n3 1 2 3\n3 0 1 2 9\n"),
            "a.ply:14:9: the file has more data than the header declares; there are lines with more numbers than the "
            "header declares");
}

TEST(Surplus, RowsOfPlyMayBeBrokenAnywhere) {
  for (const std::string data :
       {"0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2\n3 0 2 3\n", "0 0\n0 1 0 0 1 1\n0 0 1 0 3\n0 1 2 3 0 2 3\n",
        "0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3"}) {
    const auto read = MeshOfBytes("a.ply", ply_header + data);
    EXPECT_EQ(read.data.positions, (std::vector<R3::Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(read.data.triangles.size(), 2u);
    EXPECT_TRUE(read.warnings.empty());
  }
}

TEST(Surplus, ExtraPlyFaceNumbersAreIgnoredWithAWarning) {
  const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto read = MeshOfBytes("a.ply", ply_header + vertices + "3 0 1 2 .599829\n3 0 2 3 .25\n");
  EXPECT_EQ(read.data.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(read.warnings,
            std::vector<std::string>{"a.ply:14:9: warning: 2 faces have ignored numbers after those that the header "
                                     "declares, the first of them here"});
  // If they are missing, the list may begin elsewhere.
  const std::string flags =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty int flags\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(MeshErrorOf("a.ply", flags + "0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"),
            "a.ply:14:5: face 0 has more numbers than the header declares; declared: flags, vertex_indices");
}

TEST(Surplus, AnInvalidListLengthIsNamed) {
  EXPECT_EQ(MeshErrorOf("a.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n.599829 1 2\n3 0 2 3\n"),
            "a.ply:14:1: face 0: the length of the list vertex_indices must be a whole number, and not negative, got "
            "0.599829");
}

TEST(Surplus, ExtraRayVertexAndFaceNumbersAreErrors) {
  const std::string vertices = "#vertex 0 0 0 0 0 1 0 0\n#vertex 1 0 0 0 0 1 0 0\n#vertex 0 1 0 0 0 1 0 0\n";
  EXPECT_EQ(MeshErrorOf("a.ray", "#vertex 0 0 0 0 0 1 0 0 9\n"),
            "a.ray:1:25: unexpected number '9'; a vertex has 8 numbers");
  EXPECT_EQ(MeshErrorOf("a.ray", vertices + "#shape_triangle 0 0 1 2 0\n"),
            "a.ray:4:25: unexpected number '0'; a triangle has a material and 3 corners");
  EXPECT_EQ(
      MeshErrorOf("a.ray", vertices + "#shape_polygon 0 3 0 1 2 1.#QNAN\n"),
      "a.ray:4:26: unexpected number '1.#QNAN'; a polygon has a material, the number of its corners, and its corners");
  EXPECT_EQ(MeshErrorOf("a.ray", vertices + "#shape_triangle 0 0 1 2 // the last\n#end\n"), "(none)");
}

TEST(Surplus, StatementsOfObjHaveAsManyNumbersAsTheyMay) {
  const std::string face = "v 0 0 0\nv 1 0 0\nf 1 2 3\n";
  for (const std::string more : {"", " 1", " .5 .5 .5", " 255 128 0 255"})
    EXPECT_EQ(MeshErrorOf("a.obj", "v 0 1 0" + more + "\n" + face), "(none)") << more;
  const std::string known = "; supported: x y z, followed by a weight w, or a color r g b or r g b a";
  EXPECT_EQ(MeshErrorOf("a.obj", "v 0 1 0 1 2\n" + face), "a.obj:1:11: vertex 1 has 5 numbers" + known);
  EXPECT_EQ(MeshErrorOf("a.obj", "v 0 1 0 1 2 3 4 5\n" + face), "a.obj:1:17: vertex 1 has 8 numbers" + known);
  EXPECT_EQ(MeshErrorOf("a.obj", "v 0 1 0 red\n" + face),
            "a.obj:1:9: a number of vertex 1 must be a number, got 'red'");
  EXPECT_EQ(MeshErrorOf("a.obj", "vt 0 0 0\nvt 1\n"), "(none)");
  EXPECT_EQ(MeshErrorOf("a.obj", "vt 0 0 0 0\n"), "a.obj:1:10: a texture vertex has at most 3 numbers, unexpected '0'");
  EXPECT_EQ(MeshErrorOf("a.obj", "vn 0 0 1 0\n"), "a.obj:1:10: a normal has 3 numbers, unexpected '0'");
}

TEST(Surplus, AWrongBinaryStlFaceCountIsReportedAsSuch) {
  const std::string header(80, ' ');
  const std::string triangle(50, '\0');
  EXPECT_EQ(MeshErrorOf("a.stl", header + std::string("\1\0\0\0", 4) + triangle + triangle),
            "a.stl: the header declares 1 face, but the file has 1 more");
  EXPECT_EQ(MeshErrorOf("a.stl", header + std::string("\2\0\0\0", 4) + triangle),
            "a.stl: the header declares 2 faces, which need 184 bytes, but the file has 134");
  EXPECT_EQ(MeshErrorOf("a.stl", std::string(100, 'x')),
            "a.stl:1:1: an .stl file in text form must begin with 'solid', got '" + std::string(60, 'x') +
                "...' (100 bytes)");
}

TEST(Surplus, ObjListsDefinedTooLateAreNotCalledMissing) {
  EXPECT_EQ(MeshErrorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\nvn 0 0 1\n"),
            "a.obj:4:3: a normal is used before the first is defined");
  EXPECT_EQ(MeshErrorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/x 2 3\n"),
            "a.obj:4:3: a texture vertex must be a whole number, got '1/x'");
}

}  // namespace
}  // namespace ray

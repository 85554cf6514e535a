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

TEST(Surplus, ExtraOffVertexNumbersAreWarningsWhenNothingIsMissing) {
  const std::string faces = "3 0 1 2\n3 0 2 3\n";
  const auto read =
      MeshOfBytes("a.off", "OFF\n4 2 0\n0 0 0 .5 .5 1\n1 0 0 .5 .5 1\n1 1 0 .5 .5 1\n0 1 0 .5 .5 1\n" + faces);
  EXPECT_EQ(read.data.triangles.size(), 2u);
  EXPECT_EQ(read.data.positions.at(3), (R3::Point{0, 1, 0}));
  EXPECT_EQ(read.warnings.size(), 1u);
}

TEST(Surplus, ExtraPlyFaceNumbersAreIgnored) {
  const auto read =
      MeshOfBytes("a.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 .599829\n3 0 2 3 .25\n");
  EXPECT_EQ(read.data.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
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

}  // namespace
}  // namespace ray

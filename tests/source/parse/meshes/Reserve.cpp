// The memory that readers reserve for the declarations in the header of a mesh file.

#include <gtest/gtest.h>

#include "tests/source/parse/ReadMesh.h"

namespace ray {
namespace {

std::string BinaryPly(int faces, const std::string& face) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
      "element face " +
      std::to_string(faces) + "\nproperty list uchar uchar vertex_indices\nend_header\n" +
      std::string("\0\0\0\1\0\0\0\1\0", 9);
  for (int i = 0; i < faces; ++i) bytes += face;
  return bytes;
}

TEST(MeshReserve, DeclaredTrianglesGetTheirRoomOnce) {
  const R3::MeshData data = MeshOfBytes("a.ply", BinaryPly(1000, {"\3\0\1\2", 4})).data;
  EXPECT_EQ(data.triangles.size(), 1000u);
  EXPECT_EQ(data.triangles.capacity(), 1000u);
  EXPECT_TRUE(data.lines.empty());  // a binary file has none
}

TEST(MeshReserve, FacesWithoutATriangleGetNoRoom) {
  const R3::MeshData data = MeshOfBytes("a.ply", BinaryPly(100'000, {"\0", 1})).data;
  EXPECT_EQ(data.triangles.size(), 0u);
  EXPECT_LE(data.triangles.capacity(), 100'000u / 4);
}

}  // namespace
}  // namespace ray

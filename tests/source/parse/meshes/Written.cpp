// Meshes as written by other programs, and as they become in transit. files/make.py wrote them; their contents are in
// files/expected.txt, as read by the programs named there.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/source/parse/Folder.h"
#include "tests/source/parse/ReadMesh.h"

namespace ray {
namespace {

std::filesystem::path Files() { return project::Root() / "tests/source/parse/meshes/files"; }

ReadMesh WrittenMesh(const std::string& name) {
  return MeshOfBytes(name, project::BytesOf(Files() / name));
}

/// Returns the lines of a table, without comments, as words.
std::vector<std::vector<std::string>> Table(const std::string& name) {
  std::ifstream file(Files() / name);
  std::vector<std::vector<std::string>> rows;
  for (std::string line, word; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    rows.emplace_back();
    for (std::istringstream words(line); words >> word;) rows.back().push_back(word);
  }
  return rows;
}

/// Returns triangles, area, smallest and largest x y z of the used vertices: the numbers of the table.
std::vector<double> NumbersOf(const R3::MeshData& data) {
  double area = 0;
  R3::Box box;
  for (const auto& t : data.triangles) {
    const R3::Point &a = data.positions[t[0]], &b = data.positions[t[1]], &c = data.positions[t[2]];
    area += Length(Cross(b - a, c - a)) / 2;
    for (const R3::Point& p : {a, b, c}) box.Extend(p);
  }
  return {static_cast<double>(data.triangles.size()),
          area,
          box.low.x,
          box.low.y,
          box.low.z,
          box.high.x,
          box.high.y,
          box.high.z};
}

TEST(WrittenMeshes, EachHasTheTrianglesThatOtherProgramsReadFromIt) {
  const auto table = Table("expected.txt");
  ASSERT_GE(table.size(), 45u);
  for (const auto& row : table) {
    const ReadMesh read = WrittenMesh(row[0]);
    const auto numbers = NumbersOf(read.data);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double expected = std::stod(row[i + 1]);
      EXPECT_NEAR(numbers[i], expected, 1e-4 * std::max(1., std::abs(expected))) << row[0] << " " << i;
    }
  }
}

// A file that is not read exactly as written causes a warning with the position; all others are read silently.
TEST(WrittenMeshes, IgnoredDataIsReported) {
  const std::map<std::string, std::string> told{
      {"ind_normals.obj", "ind_normals.obj:17:13: warning: 4 uses of normals that are not finite are ignored"},
      {"inf_normals.obj", "inf_normals.obj:17:3: warning: 36 uses of normals that are not finite are ignored"},
      {"nan_normals.obj", "nan_normals.obj:17:3: warning: 14 uses of normals that are not finite are ignored"},
      {"nan_normals.ply", "nan_normals.ply:14:15: warning: 8 uses of normals that are not finite are ignored"},
      {"no_lists.obj", "36 corners have an index of a normal, but the file has none"},
      {"no_normals.obj", "no_normals.obj:9:3: warning: 36 corners have an index of a normal, but the file has none"},
      {"no_uvs.obj", "54 corners have an index of texture coordinates, but the file has none"},
      {"zeros.obj", "zeros.obj:13:3: warning: 60 corners have an index of texture coordinates"},
      {"trailing.stl", "trailing.stl: warning: 2 bytes after the last face ignored; the header declares 12 faces"},
      {"trailing_text.stl", "18 bytes after the last face ignored"},
      {"trailing_long.stl", "77 bytes after the last face ignored"},
      {"solid_trailing.stl", "2 bytes after the last face ignored"},
      {"solid_capitals_trailing.stl", "12 bytes after the last face ignored"},
  };
  for (const auto& row : Table("expected.txt")) {
    std::string all;
    for (const std::string& warning : WrittenMesh(row[0]).warnings) all += warning + "\n";
    const auto expected = told.find(row[0]);
    if (expected == told.end())
      EXPECT_EQ(all, "") << row[0];
    else
      EXPECT_TRUE(Contains(all, expected->second)) << all;
  }
}

// A vertex has one pair of texture coordinates, so vertices at seams between faces are split.
TEST(WrittenMeshes, FacesOfPlyKeepTheirOwnTextureCoordinates) {
  for (const auto& row : Table("texcoords.txt")) {
    const R3::MeshData data = WrittenMesh(row[0]).data;
    ASSERT_EQ(data.uvs.size(), data.positions.size()) << row[0];
    std::vector<R2::Point> expected;
    for (std::size_t i = 1; i + 1 < row.size(); i += 2) expected.push_back({std::stof(row[i]), std::stof(row[i + 1])});
    if (row[0] == "wedges_quads.ply") {  // each of its quads becomes a fan of two triangles
      const auto e = expected;
      expected = {e[0], e[1], e[2], e[0], e[2], e[3], e[4], e[5], e[6], e[4], e[6], e[7]};
    }
    std::vector<R2::Point> found;
    for (const auto& t : data.triangles)
      for (const std::uint32_t corner : t) found.push_back(data.uvs[corner]);
    ASSERT_EQ(found.size(), expected.size()) << row[0];
    for (std::size_t i = 0; i < found.size(); ++i) {  // plyfile has them in single precision
      EXPECT_NEAR(found[i].x, expected[i].x, 1e-7) << row[0] << " " << i;
      EXPECT_NEAR(found[i].y, expected[i].y, 1e-7) << row[0] << " " << i;
    }
  }
}

TEST(WrittenMeshes, CornersOfPlyThatAgreeAreOneVertex) {
  // MeshLab unrolled the cone, so that every vertex has one pair of texture coordinates.
  EXPECT_EQ(WrittenMesh("wedges_flat.ply").data.positions.size(), 11u);
  // The two quads of the other file share two positions with different coordinates.
  EXPECT_EQ(WrittenMesh("wedges_quads.ply").data.positions.size(), 8u);
}

TEST(WrittenMeshes, OffNormalsFollowColorsInFilesFromMeshLab) {
  // Its corners' normals point away from the box's center, and are not colors of 0 or 255.
  const R3::MeshData data = WrittenMesh("ncst.off").data;
  ASSERT_EQ(data.normals.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const R3::Vector away = data.positions[i] - R3::Point{1, 0.5, 1.5};
    const R3::Vector normal = AsVector(data.normals[i]);
    for (int axis = 0; axis < 3; ++axis) EXPECT_GT(normal[axis] * away[axis], 0) << i;
  }
  EXPECT_EQ(data.uvs.size(), 8u);
}

}  // namespace
}  // namespace ray

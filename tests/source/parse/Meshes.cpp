#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>

#include "source/parse/meshes/MeshFormat.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"
#include "tests/source/parse/ReadMesh.h"

namespace ray {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

ReadMesh Read(const std::string& name, std::string bytes) { return MeshOfBytes(name, std::move(bytes)); }

/// Expects K9 for every prefix: a mesh whose triangles are valid, or a clean error.
bool Reads(const std::string& name, std::string bytes) {
  try {
    const ReadMesh read = Read(name, std::move(bytes));
    for (const auto& triangle : read.data.triangles)
      for (const std::uint32_t corner : triangle) EXPECT_LT(corner, read.data.positions.size());
    return true;
  } catch (const SceneError&) {
    return false;
  }
}

template <class... Numbers>
std::string Binary(std::endian order, Numbers... numbers) {
  std::string bytes;
  const auto append = [&](auto number) {
    char raw[sizeof(number)];
    std::memcpy(raw, &number, sizeof(number));
    if (order != std::endian::native) std::reverse(raw, raw + sizeof(number));
    bytes.append(raw, sizeof(number));
  };
  (append(numbers), ...);
  return bytes;
}

const std::string square_off = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
const Triangles fan{{0, 1, 2}, {0, 2, 3}};

TEST(Off, CountsMayStandOnTheHeadersLineOrTheNext) {
  EXPECT_EQ(Read("a.off", square_off).data.triangles, fan);
  EXPECT_EQ(Read("a.off", "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3").data.triangles, fan);
  EXPECT_EQ(
      Read("a.off", "# c\n\nOFF # c\n\n4 1\n0 0 0\n#c\n1 0 0\n\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n").data.triangles,
      fan);
}

TEST(Off, CountsMayStandOnLinesOfTheirOwn) {
  const std::string rest = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  for (const char* counts : {"4\n1\n0\n", "4 1\n0\n", "4\n1 0\n", "4\n1\n"}) {
    const auto read = Read("a.off", "OFF\n" + std::string(counts) + rest);
    EXPECT_EQ(read.data.triangles, fan) << counts;
    EXPECT_EQ(read.data.positions.at(1), (R3::Point{1, 0, 0})) << counts;
    EXPECT_TRUE(read.warnings.empty()) << counts;
  }
}

TEST(Off, HeadersWithColorsNormalsAndTextureCoordinatesAreUnderstood) {
  const auto colored = Read("a.off", "COFF 3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(colored.data.positions.at(1), (R3::Point{1, 0, 0}));
  EXPECT_TRUE(colored.warnings.empty());
  const auto all =
      Read("a.off",
           "STCNOFF 3 1 0\n0 0 0 0 0 1 9 9 9 9 .5 .25\n1 0 0 0 0 1 9 9 9 9 0 0\n0 1 0 0 0 1 9 9 9 9 0 0\n3 0 1 2\n");
  EXPECT_EQ(all.data.normals.at(0), (R3::Normal{0, 0, 1}));
  EXPECT_EQ(all.data.uvs.at(0).x, 0.5);
  EXPECT_EQ(all.data.uvs.at(0).y, 0.25);
  EXPECT_EQ(all.warnings.size(), 0u);
}

TEST(Extremes, D8_AFaceOf65536CornersIsCutUp) {
  constexpr int n = 65'536;
  std::string off = "OFF " + std::to_string(n) + " 1 0\n";
  std::string face = std::to_string(n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    off += std::to_string(std::cos(angle) * 1e6) + " " + std::to_string(std::sin(angle) * 1e6) + " 0\n";
    face += " " + std::to_string(i);
  }
  EXPECT_EQ(Read("a.off", off + face).data.triangles.size(), n - 2u);
}

TEST(RayMesh, BothFaceCommandsAreReadAndOthersSkipped) {
  const auto read = Read("a.ray",
                         "#material 1 0 0 \n#vertex 0 0 0  0 0 1  0 0\n#vertex 1 0 0  0 0 1  1 0\n"
                         "#vertex 1 1 0  0 0 1  1 1\n#camera 0 0 1\n#vertex 0 1 0  0 0 1  0 1\n"
                         "#shape_triangle 0  0 1 2\n#shape_polygon 7 4  0 1 2 3\n");
  EXPECT_EQ(read.data.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(read.data.uvs.at(2).x, 1);
  EXPECT_EQ(read.data.normals.at(0), (R3::Normal{0, 0, 1}));
}

TEST(Obj, CornersOfAllFormsAndNegativeIndicesAreRead) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt .5 .25\nvn 0 0 2\n";
  for (const char* face : {"f 1 2 3 4", "f -4 -3 -2 -1", "f 1/1 2/1 3/1 4/1", "f 1//1 2//-1 3//1 4//1",
                           "f 1/1/1 2/1/1 3/1/1 4/-1/-1", "f 1 2 \\\n 3 4", "f 1 2 3 4 # comment"}) {
    const auto read = Read("a.obj", vertices + face + "\n");
    EXPECT_EQ(read.data.triangles, fan) << face;
    EXPECT_EQ(read.data.positions.size(), 4u) << face;
  }
}

TEST(Obj, OtherStatementsAreSkipped) {
  const auto read = Read(
      "a.obj", "mtllib f v.mtl\no v f\ng f 1 2 3\nv 0 0 0 1\ns off\nv 1 0 0 1\nusemtl f\nv 0 1 0 1\nf 1 2 3\nl 1 2\n");
  EXPECT_EQ(read.data.triangles, (Triangles{{0, 1, 2}}));
}

TEST(Obj, APositionWithTwoTextureCoordinatesBecomesTwoVertices) {
  const auto read = Read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 2/2 4/2 3/1\n");
  EXPECT_EQ(read.data.positions.size(), 5u);
  ASSERT_EQ(read.data.triangles.size(), 2u);
  const auto second = read.data.triangles[1];
  EXPECT_EQ(read.data.positions.at(second[0]), (R3::Point{1, 0, 0}));
  EXPECT_EQ(read.data.uvs.at(second[0]).x, 1);
  EXPECT_EQ(read.data.uvs.at(read.data.triangles[0][1]).x, 0);
  EXPECT_EQ(read.data.triangles[0][2], second[2]);
}

TEST(Obj, ACornerWithoutANormalGetsNone) {
  const auto read = Read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2 3\n");
  ASSERT_EQ(read.data.normals.size(), 3u);
  EXPECT_EQ(read.data.normals[read.data.triangles.at(0)[0]], (R3::Normal{0, 0, 1}));
  EXPECT_EQ(read.data.normals[read.data.triangles.at(0)[1]], (R3::Normal{}));
}

const std::string ply_header =
    " 1.0\ncomment x\nobj_info y\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\n"
    "property uchar red\nelement edge 1\nproperty list uchar int ends\nproperty char c\n"
    "element face 2\nproperty int flags\nproperty list uchar ushort vertex_indices\nend_header\n";

std::string BinaryPly(std::endian order) {
  std::string bytes =
      order == std::endian::little ? "ply\nformat binary_little_endian" : "ply\nformat binary_big_endian";
  bytes += ply_header;
  const auto vertex = [&](float x, double y) { bytes += Binary(order, x, y, std::int16_t{-2}, std::uint8_t{255}); };
  vertex(0, 0), vertex(1, 0), vertex(1, 1), vertex(0, 1);
  bytes += Binary(order, std::uint8_t{2}, 0, 1, std::int8_t{7});
  bytes += Binary(order, 5, std::uint8_t{4}, std::uint16_t{0}, std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3});
  return bytes + Binary(order, 5, std::uint8_t{3}, std::uint16_t{3}, std::uint16_t{2}, std::uint16_t{1});
}

const std::string ascii_ply = "ply\nformat ascii" + ply_header +
                              "0 0 -2 255\n1 0 -2 255\n1 1 -2 255\n0 1 -2 255\n2 0 1 7\n5 4 0 1 2 3\n5 3 3 2 1\n";

TEST(Ply, AllThreeEncodingsGiveTheSameMesh) {
  for (const std::string& file : {ascii_ply, BinaryPly(std::endian::little), BinaryPly(std::endian::big)}) {
    const auto read = Read("a.ply", file);
    EXPECT_EQ(read.data.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {3, 2, 1}}));
    EXPECT_EQ(read.data.positions, (std::vector<R3::Point>{{0, 0, -2}, {1, 0, -2}, {1, 1, -2}, {0, 1, -2}}));
    EXPECT_TRUE(read.warnings.empty());
  }
}

TEST(Ply, DataBeginsRightAfterAnyHeaderLineEnd) {
  // 0x0a as the first byte of the data, behind line ends of one and of two bytes.
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string header;
    for (const char* line : {"ply", "format binary_little_endian 1.0", "element vertex 1", "property char x",
                             "property char y", "property char z", "end_header"})
      header += line + end;
    EXPECT_EQ(Read("a.ply", header + "\n\r\n").data.positions.at(0), (R3::Point{10, 13, 10})) << end.size();
  }
}

TEST(Ply, NormalsAndTextureCoordinatesAreReadUnderAllNames) {
  for (const char* names : {"s t", "u v", "texture_u texture_v"}) {
    const std::string both = names;
    const std::string first = both.substr(0, both.find(' ')), second = both.substr(both.find(' ') + 1);
    const auto read =
        Read("a.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
             "property float nx\nproperty float ny\nproperty float nz\nproperty float " +
                 first + "\nproperty float " + second + "\nend_header\n1 2 3  0 0 1  0.5 0.25\n");
    EXPECT_EQ(read.data.normals.at(0), (R3::Normal{0, 0, 1}));
    EXPECT_EQ(read.data.uvs.at(0).x, 0.5);
    EXPECT_EQ(read.data.uvs.at(0).y, 0.25);
  }
}

TEST(Ply, StripsAlternateTheirWindingAndRestartAtMinusOne) {
  const auto read =
      Read("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
           "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n11 0 1 2 3 -1 2 1 3 3 4 1\n");
  // The second strip repeats vertex 3, so its second and third triangle are degenerate; the fourth is flipped.
  EXPECT_EQ(read.data.triangles, (Triangles{{0, 1, 2}, {2, 1, 3}, {2, 1, 3}, {4, 3, 1}}));
}

std::string BinaryStl() {
  const auto little = std::endian::little;
  return "solid, though binary" + std::string(60, ' ') + Binary(little, std::uint32_t{1}) +
         Binary(little, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, std::uint16_t{0});
}

const std::string ascii_stl =
    "solid my cube\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n"
    "  endloop\n endfacet\nendsolid my cube\n";

TEST(Stl, AsciiAndBinaryWithSolidGiveTheSameMesh) {
  for (const std::string& file : {ascii_stl, BinaryStl()}) {
    const auto read = Read("a.STL", file);
    EXPECT_EQ(read.data.positions, (std::vector<R3::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(read.data.triangles, (Triangles{{0, 1, 2}}));
  }
}

TEST(Extremes, K9_MeshesCutAnywhereAreErrorsOrMeshes) {
  const std::vector<std::pair<std::string, std::string>> samples{
      {"a.off", square_off},
      {"a.ray",
       "#vertex 0 0 0 0 0 1 0 0\n#vertex 1 0 0 0 0 1 0 0\n#vertex 0 1 0 0 0 1 0 0\n#shape_polygon 0 3 0 1 2\n"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"},
      {"a.ply", ascii_ply},
      {"b.ply", BinaryPly(std::endian::little)},
      {"c.ply", BinaryPly(std::endian::big)},
      {"a.stl", ascii_stl},
      {"b.stl", BinaryStl()},
  };
  for (const auto& [name, bytes] : samples) {
    ASSERT_TRUE(Reads(name, bytes)) << name;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const bool reads = Reads(name, bytes.substr(0, length));
      const bool is_binary = name[0] != 'a';
      EXPECT_FALSE(reads && is_binary) << name << " cut to " << length;
    }
    int errors = 0;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      std::string flipped = bytes;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
      errors += !Reads(name, flipped);
    }
    EXPECT_GT(errors, 0) << name;
  }
}

TEST(Extremes, K10_TenMebibytesOfAwkwardFacesTakeAtMostTenSeconds) {
  const auto seconds = [](const std::string& name, const std::string& bytes) {
    const auto start = std::chrono::steady_clock::now();
    Reads(name, bytes);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  // Combs of 256 corners: concave, and every second corner prevents an ear.
  std::string combs, one_place = "v 0 0 0\n", joined = "v 0 0 0\nf ";
  for (int i = 0; i < 256; ++i)
    combs += "v " + std::to_string(i == 255 ? 0 : i) + " " + std::to_string(i == 255 ? -9 : i % 2) + " 0\n";
  std::string comb = "f";
  for (int i = 256; i > 0; --i) comb += " " + std::to_string(i);
  while (combs.size() < (10 << 20)) combs += comb + "\n";
  EXPECT_LT(seconds("a.obj", combs), 10 * patience);
  // One position with very many texture coordinates.
  for (int i = 1; one_place.size() < (10 << 20); ++i)
    one_place += "vt " + std::to_string(i) + " 0\nf 1/" + std::to_string(i) + " 1 1\n";
  EXPECT_LT(seconds("a.obj", one_place), 10 * patience);
  while (joined.size() < (10 << 20)) joined += "\\\n";
  EXPECT_LT(seconds("a.obj", joined), 10 * patience);
}

TEST(Meshes, AQuarterMillionTrianglesAreReadWithinTwoSeconds) {
  const std::filesystem::path file = project::Root() / "../shared/meshes/igea.ply";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no mesh at " << file;
  std::string bytes = project::BytesOf(file);
  const auto start = std::chrono::steady_clock::now();
  const auto read = Read("igea.ply", std::move(bytes));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 2 * patience);
  EXPECT_EQ(read.data.positions.size(), 134345u);
  EXPECT_EQ(read.data.triangles.size(), 268686u);
}

TEST(Meshes, ExtensionsAreKnownInAnyLetterCase) {
  EXPECT_EQ(MeshFormatForName("A.OFF"), MeshFormatForName("b.off"));
  EXPECT_TRUE(MeshFormatForName("x/y.Obj"));
  EXPECT_FALSE(MeshFormatForName("off"));
  EXPECT_FALSE(MeshFormatForName("a.offx"));
}

TEST(Meshes, AMeshFileAloneIsAScene) {
  const auto file = project::Root() / "scenes/meshes/icosahedron.off";
  const ParsedScene parsed = Parse(file, {});
  EXPECT_EQ(parsed.warnings, std::vector<std::string>{}) << "normals were not requested";
  const Scene& scene = parsed.scene;
  ASSERT_EQ(scene.root.children.size(), 2u) << "and the ground";
  EXPECT_EQ(scene.root.children[0].shape->Elements(), 20);
  EXPECT_EQ(scene.files, std::vector<std::string>{file.string()});
  EXPECT_FALSE(scene.lights.empty());
  const project::Stage stage(file);
  EXPECT_GT(project::Render(stage, project::Sized(9)).image.At(4, 4).r, 0) << "the default camera sees it";
}

}  // namespace
}  // namespace ray

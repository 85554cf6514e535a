// Models with the materials of their files. models/make.py wrote those of Blender, MeshLab and SketchUp, according to
// these programs' documentation; the expected colors are derived here from the numbers in it.

#include "source/parse/Model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "R3/Mesh.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

using project::BytesOf;

/// A folder with copies of the models, for scenes that use them.
struct Models : Folder {
  Models() {
    const fs::path from = project::Root() / "tests/source/parse/models";
    for (const auto& entry : fs::recursive_directory_iterator(from))
      if (entry.is_regular_file()) Write(entry.path().lexically_relative(from).string(), BytesOf(entry.path()));
  }

  /// Returns the color along -z at a point of a model in front of gray, in light along -z.
  R2::Color SeenAt(const std::string& model, double x, double y, const std::string& how = "materials") const {
    std::ostringstream scene;
    scene << "camera " << x << ' ' << y << " 50  0 0 -1  0 1 0  1e-6 .01 100\nbackground .4 .4 .4\n"
          << "dir_light 1 1 1  0 0 -1\nmaterial 0 0 0  0 .5 0  0 0 0  0 0 0  0 0 0  1 1 0\nmesh 0 " << model << ' '
          << how << '\n';
    RenderSettings settings = project::Sized(1);
    return project::Render(project::Stage(Parse(Write("scene.scn", scene.str()), {}).scene), settings).image.At(0, 0);
  }
};

void ExpectColor(const R2::Color& seen, const R2::Color& expected, double within = 1e-6) {
  EXPECT_NEAR(seen.r, expected.r, within);
  EXPECT_NEAR(seen.g, expected.g, within);
  EXPECT_NEAR(seen.b, expected.b, within);
}

TEST(Models, OfBlenderHaveTheirColorsAndTextures) {
  const Models models;
  // Columns of the image are 51, 102, 153 and 204 255ths; -s 2 and -o .25 make 2 u + .25 of u = (x + 1) / 2.
  ExpectColor(models.SeenAt("blender_box.obj", -0.875, 1), {0.4, 0.2, 0});        // .375: the second
  ExpectColor(models.SeenAt("blender_box.obj", -0.375, 1), {0.8, 0.4, 0});        // .875: the fourth
  ExpectColor(models.SeenAt("blender_box.obj", -0.125, 1), {0.2, 25 / 255., 0});  // 1.125: the first again
  // The octahedron is smooth by its group: at the corner towards the light its normal is the axis.
  const R2::Color corner = models.SeenAt("blender_box.obj", 3 + 1e-7, 1 + 1e-7, "smooth materials");
  ExpectColor(corner, {0.05 + 0.25, 0.2 + 0.25, 0.7 + 0.25}, 1e-4);  // kd, and ks where the highlight is strongest
  // Flat, its faces are tilted by 54.7 degrees, whose cosine is 1 / sqrt(3).
  const double cosine = 1 / std::sqrt(3);
  ExpectColor(models.SeenAt("blender_box.obj", 3.2, 1.2), {0.05 * cosine, 0.2 * cosine, 0.7 * cosine}, 1e-4);
}

TEST(Models, OfBlenderTransmitEmitMirrorAndHaveNormalMaps) {
  const Models models;
  // d .25: a quarter of kd, and three quarters of the background, through both sides; the back is in shadow.
  const double behind = 0.75 * 0.75 * 0.4;
  ExpectColor(models.SeenAt("blender_glass.obj", 0, 1), {0.05 + behind, 0.2 + behind, 0.1 + behind});
  ExpectColor(models.SeenAt("blender_lamp.obj", 0.5, 0.5), {0.9, 0.6, 0.3});
  ExpectColor(models.SeenAt("blender_glass.obj", -2.5, 0.5), {0.1 + 0.28, 0.1 + 0.24, 0.1 + 0.16});
  // 204, 128 and 230 255ths are 2 c - 1 = .6, .004 and .804, whose unit vector is tilted by a cosine of .8014.
  ExpectColor(models.SeenAt("blender_glass.obj", -2.5, 2), {0.4007, 0.4007, 0.4007}, 1e-4);
}

TEST(Models, OfMeshLabHaveTheColorsOfTheirVertices) {
  const Models models;
  for (const double x : {0.25, 1.0, 1.5})
    for (const double y : {0.25, 0.5, 0.9})
      ExpectColor(models.SeenAt("meshlab_colors.obj", x, y), {x / 2, y, 1});  // as at the corners, and linear between
}

TEST(Models, OfMeshLabHaveSeveralTextures) {
  const Models models;
  // Tr .5 halves kd .5 1 1; blue and white squares of the image. The back sides are in shadow, seen through half of the
  // front, and transmit half of the half.
  const double behind = 0.25 * 0.4;
  ExpectColor(models.SeenAt("meshlab_textures.obj", 0.5, 0.25), {behind, behind, 0.5 + behind});
  ExpectColor(models.SeenAt("meshlab_textures.obj", 1.5, 0.25), {0.25 + behind, 0.5 + behind, 0.5 + behind});
}

TEST(Models, OfSketchUpHaveTexturesOfWindowsPaths) {
  const Models models;
  ExpectColor(models.SeenAt("sketchup_house.obj", 1, 0.5), {0.480392 * 0.8, 0.270588 * 0.6, 0.2 * 0.4});
}

TEST(Models, FacesWithoutAMaterialTakeTheScenes) {
  const Models models;
  const Scene scene = Parse(models.Write("scene.scn",
                                         "material 0 0 0 0 .5 0 0 0 0 0 0 0 0 0 0 1 1 0\n"
                                         "mesh 0 sketchup_house.obj materials\n"),
                            {})
                          .scene;
  ASSERT_EQ(scene.root.children.size(), 4u);
  std::vector<double> greens;
  for (const Node& part : scene.root.children)
    greens.push_back(scene.materials.at(static_cast<std::size_t>(part.material)).kd.g);
  // White sides, brick walls, the roof that no library has, and glass, half of whose .6 is visible.
  EXPECT_EQ(greens, (std::vector<double>{1, 0.270588, 0.5, 0.3}));
}

// Course files state a material for every mesh, and mean it.
TEST(Models, WithoutTheKeywordAMeshHasTheScenesMaterial) {
  const Models models;
  const Scene scene =
      Parse(models.Write("scene.scn", red + "mesh 0 blender_glass.obj\nmesh 0 meshlab_colors.obj\n"), {}).scene;
  ASSERT_EQ(scene.root.children.size(), 2u);
  EXPECT_EQ(scene.root.children[0].material, 1);
  ExpectColor(models.SeenAt("meshlab_colors.obj", 0.25, 0.5, ""), {0, 0.5, 0});
}

TEST(Models, UsedTwiceShareTheirMeshesAndMaterials) {
  const Models models;
  const Scene scene = Parse(models.Write("scene.scn",
                                         "mesh -1 blender_box.obj materials\n"
                                         "begin -1 1 0 0 9 0 1 0 0 0 0 1 0 0 0 0 1\n"
                                         "mesh -1 blender_box.obj materials\nend\n"),
                            {})
                          .scene;
  EXPECT_EQ(scene.materials.size(), 4u);  // the default one, and three
  EXPECT_EQ(scene.root.children[0].shape, scene.root.children[3].children[0].shape);
}

/// Returns the warnings about a file, without the folder.
std::vector<std::string> WarningsOf(const Folder& folder, const std::string& name) {
  std::vector<std::string> warnings = Parse(folder / name, {}).warnings;
  const std::string prefix = folder.Path().string() + "/";
  for (std::string& warning : warnings)
    for (std::size_t i; (i = warning.find(prefix)) != std::string::npos;) warning.erase(i, prefix.size());
  return warnings;
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Models, NamesMayHaveBlanksAndCommentsBehindThem) {
  const Folder folder;
  folder.Write("a b.mtl",
               "newmtl Material #25\nKd 1 0 0\nnewmtl Material #26\nKd 0 1 0\nnewmtl blue # the sky\nKd 0 0 1\n");
  folder.Write("a.obj", "mtllib a b.mtl\n" + triangle +
                            "usemtl Material #26\nf 1 2 3\nusemtl blue\nf 1 3 2\nusemtl Material #25 # x\nf 2 1 3\n");
  const ParsedScene parsed = Parse(folder / "a.obj", {});
  EXPECT_TRUE(parsed.warnings.empty());
  std::vector<R2::Color> colors;
  for (const Node& node : parsed.scene.root.children)
    colors.push_back(parsed.scene.materials[static_cast<std::size_t>(node.material)].kd);
  ASSERT_EQ(colors.size(), 4u);  // the last is the ground
  EXPECT_EQ(colors[0], (R2::Color{0, 1, 0}));
  EXPECT_EQ(colors[1], (R2::Color{0, 0, 1}));
  EXPECT_EQ(colors[2], (R2::Color{1, 0, 0}));
}

Material MaterialOf(const std::string& statements) {
  const Folder folder;
  folder.Write("a.mtl", "newmtl a\n" + statements);
  folder.Write("a.obj", "mtllib a.mtl\n" + triangle + "usemtl a\nf 1 2 3\n");
  const Scene scene = Parse(folder / "a.obj", {}).scene;
  return scene.materials.at(static_cast<std::size_t>(scene.root.children.at(0).material));
}

TEST(Models, NumbersOfMaterialsMeanWhatTheirFormatSays) {
  const Material plain = MaterialOf("");
  EXPECT_EQ(plain.kd, default_gray);
  EXPECT_EQ(plain.ks, (R2::Color{}));
  EXPECT_EQ(plain.kr, (R2::Color{}));
  EXPECT_EQ(plain.kt, (R2::Color{}));
  EXPECT_EQ(MaterialOf("Kd .5\n").kd, (R2::Color{0.5, 0.5, 0.5})) << "one number is for all channels";
  EXPECT_EQ(MaterialOf("KD 1 0 0\n").kd, (R2::Color{1, 0, 0})) << "keywords are known in any letter case";
  EXPECT_EQ(MaterialOf("Ka .1 .2 .3\nKd 1 0 0\n").ka, (R2::Color{0.1, 0.2, 0.3}));
  EXPECT_EQ(MaterialOf("Ka 1 1 1\nKd 1 0 0\n").ka, (R2::Color{1, 0, 0}))
      << "white is what programs write that have none";
  EXPECT_EQ(MaterialOf("Ke 2 3 4\n").emission, (R2::Color{2, 3, 4}));
}

TEST(Models, HighlightsAndMirrorsDependOnTheIllumination) {
  const std::string shiny = "Ks .5 .6 .7\nNs 90\n";
  const R2::Color ks{0.5, 0.6, 0.7}, none;
  EXPECT_EQ(MaterialOf(shiny).ks, ks);
  EXPECT_EQ(MaterialOf(shiny).n, 90);
  EXPECT_EQ(MaterialOf(shiny + "illum 1\n").ks, none);
  EXPECT_EQ(MaterialOf(shiny + "illum 2\n").kr, none);
  EXPECT_EQ(MaterialOf(shiny + "illum 3\n").kr, ks);
  EXPECT_EQ(MaterialOf("Ks 1 1 1\nNs 0\n").ks, none) << "a highlight of exponent 0 would be everywhere";
}

TEST(Models, MaterialsAreClearByDissolveOrByRefraction) {
  const R2::Color none, half{0.5, 0.5, 0.5};
  EXPECT_EQ(MaterialOf("Kd 1 1 1\nd .5\n").kt, half);
  EXPECT_EQ(MaterialOf("Kd 1 1 1\nd .5\n").kd, half);
  EXPECT_EQ(MaterialOf("d .5\nNi 1.5\n").ir, 1) << "a dissolved material does not bend light";
  EXPECT_EQ(MaterialOf("Tr .5\n").kt, half);
  EXPECT_EQ(MaterialOf("d 1\nTr 1\n").kt, none) << "d counts";
  EXPECT_EQ(MaterialOf("Tf 1 1 1\nillum 4\n").kt, none) << "programs write it for opaque materials";
  EXPECT_EQ(MaterialOf("d .5\nTf 1 0 0\n").kt, (R2::Color{0.5, 0, 0}));
  const Material glass = MaterialOf("Kd 0 0 0\nTf .9 .8 .7\nNi 1.5\nillum 7\n");
  EXPECT_EQ(glass.kt, (R2::Color{0.9, 0.8, 0.7}));
  EXPECT_EQ(glass.ir, 1.5);
}

/// Returns the materials of a model's parts, in order.
std::vector<Material> MaterialsOf(const Folder& folder, const std::string& name) {
  const Scene scene = Parse(folder / name, {}).scene;
  std::vector<Material> materials;
  for (const Node& node : scene.root.children)  // except the ground, which is the last
    materials.push_back(scene.materials.at(static_cast<std::size_t>(node.material)));
  materials.pop_back();
  return materials;
}

TEST(Models, BumpsAreHundredthsOfTheExtentHigh) {
  const Folder folder;
  folder.Write("gray.ppm", "P3 1 1 255 128 128 128\n");
  folder.Write("a.mtl", "newmtl a\nmap_bump -bm 2 gray.ppm\n");
  folder.Write("a.obj", "mtllib a.mtl\n" + triangle + "vt 0 0\nvt 2 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n");
  const Material a = MaterialsOf(folder, "a.obj").at(0);
  EXPECT_TRUE(a.bump);
  EXPECT_DOUBLE_EQ(a.bump_height, 0.02);
}

TEST(Models, OfPlyHaveVertexColorsAndTextures) {
  const Folder folder;
  folder.Write("a.ppm", "P3 1 1 255 51 102 153\n");
  const std::string vertex = "property float x\nproperty float y\nproperty float z\n";
  const std::string end = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const auto kd_and_color = [&](const std::string& comment, const std::string& properties, const std::string& values) {
    folder.Write("a.ply", "ply\nformat ascii 1.0\n" + comment + "element vertex 3\n" + vertex + properties + end +
                              "0 0 0 " + values + "\n1 0 0 " + values + "\n0 1 0 " + values + "\n3 0 1 2\n");
    const Scene scene = Parse(folder / "a.ply", {}).scene;
    const Node& node = scene.root.children.at(0);
    const auto& colors = dynamic_cast<const R3::Mesh&>(*node.shape).Data().colors;
    const Material& material = scene.materials[static_cast<std::size_t>(node.material)];
    const auto color = colors.empty() ? std::array<float, 3>{} : colors[0];
    EXPECT_EQ(material.has_vertex_colors, !colors.empty());
    return std::pair(std::array{material.kd.r, material.texture ? double{material.texture->image.At(0, 0).g} : -1.},
                     color);
  };
  const std::string bytes = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  EXPECT_EQ(kd_and_color("", bytes, "51 102 255"), (std::pair(std::array{1., -1.}, std::array{0.2f, 0.4f, 1.f})));
  EXPECT_EQ(kd_and_color("", bytes, "1 1 0").second, (std::array{1 / 255.f, 1 / 255.f, 0.f})) << "bytes anyway";
  const std::string floats = "property float red\nproperty float green\nproperty float blue\n";
  EXPECT_EQ(kd_and_color("", floats, ".25 .5 1").second, (std::array{0.25f, 0.5f, 1.f}));
  EXPECT_EQ(kd_and_color("", floats, "51 102 255").second, (std::array{0.2f, 0.4f, 1.f})) << "more than 1 is of 255";
  const std::string shorts = "property ushort red\nproperty ushort green\nproperty ushort blue\n";
  EXPECT_EQ(kd_and_color("", shorts, "13107 0 65535").second, (std::array{0.2f, 0.f, 1.f}));
  EXPECT_EQ(kd_and_color("comment TextureFile a.ppm\n", "property float s\nproperty float t\n", "0 0").first[1],
            double{102 / 255.f});
}

using Colors = std::vector<std::array<float, 3>>;

/// Returns the vertex colors of a single mesh.
Colors ColorsOf(const Folder& folder, const std::string& name) {
  const Scene scene = Parse(folder / name, {}).scene;
  return dynamic_cast<const R3::Mesh&>(*scene.root.children.at(0).shape).Data().colors;
}

TEST(Models, InvalidVertexColorsAreWhite) {
  const Folder folder;
  folder.Write("a.obj", "v 0 0 0 .25 .5 .75\nv 1 0 0\nv 0 1 0 nan 0 0\nv 1 1 0 0 -1 0\nf 1 2 4 3\n");
  const std::array<float, 3> white{1, 1, 1};
  EXPECT_EQ(ColorsOf(folder, "a.obj"), (Colors{{0.25f, 0.5f, 0.75f}, white, white, white}));
}

TEST(Models, BytesOfColorsAreDecodedInALinearWorkflow) {
  const Folder folder;
  folder.Write("a.off", "COFF\n3 1 0\n0 0 0 188 0 255 255\n1 0 0 188 0 255 255\n0 1 0 188 0 255 255\n3 0 1 2\n");
  ParseOptions options;
  options.decode_srgb = true;
  const Scene scene = Parse(folder / "a.off", options).scene;
  const auto& color = dynamic_cast<const R3::Mesh&>(*scene.root.children.at(0).shape).Data().colors.at(0);
  // ((188/255 + .055) / 1.055)^2.4, IEC 61966-2-1
  EXPECT_NEAR(color[0], 0.50289, 1e-5);
  EXPECT_EQ(color[1], 0);
  EXPECT_EQ(color[2], 1);
}

const std::string one_face = triangle + "usemtl a\nf 1 2 3\n";

// MeshLab before 2023 and programs for photogrammetry write this for materials that they show as opaque.
TEST(Models, WithoutTransparencyInTheirIlluminationAreOpaque) {
  const R2::Color kd{0.1, 0.2, 0.3}, none;
  for (const char* illum : {"", "illum 0\n", "illum 1\n", "illum 2\n", "illum 3\n"}) {
    const Material material = MaterialOf("Kd .1 .2 .3\nTr 1.000000\n" + std::string(illum));
    EXPECT_EQ(material.kd, kd) << illum;
    EXPECT_EQ(material.kt, none) << illum;
  }
  EXPECT_EQ(MaterialOf("Kd .1 .2 .3\nTr 1\nillum 4\n").kd, none) << "glass";
  EXPECT_EQ(MaterialOf("Kd .1 .2 .3\nTr .5\nillum 1\n").kt, (R2::Color{0.5, 0.5, 0.5}));
}

TEST(Models, WithoutAMapsFileOrAMaterialsNameAreRead) {
  const Folder folder;
  folder.Write("a.mtl",
               "newmtl\nKd .9 .8 .7\nnewmtl a\nKd .1 .2 .3\nmap_Kd\nmap_Bump -bm 2\nnorm # none\nmap_Kd -s 1 1\n");
  folder.Write("a.obj", "mtllib a.mtl\n" + triangle + "usemtl\nf 1 2 3\nusemtl a\nf 1 3 2\n");
  const auto materials = MaterialsOf(folder, "a.obj");
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0].kd, (R2::Color{0.9, 0.8, 0.7}));
  EXPECT_EQ(materials[1].kd, (R2::Color{0.1, 0.2, 0.3}));
}

TEST(Models, LibrariesAreFoundAsExportersNameThem) {
  const Folder folder;
  const std::string red = "newmtl a\nKd .75 0 0\n", blue = "newmtl b\nKd 0 0 .25\n";
  for (const char* name : {"x.mtl", "my x.mtl", "parts/x.mtl", "parts/deep/my x.mtl", "a #1.mtl"})
    folder.Write(name, red);
  folder.Write("y.mtl", blue);
  const auto finds = [&](const std::string& statements) {
    folder.Write("a.obj", statements + one_face);
    EXPECT_TRUE(WarningsOf(folder, "a.obj").empty()) << WarningsOf(folder, "a.obj")[0];
    EXPECT_EQ(MaterialsOf(folder, "a.obj").at(0).kd, (R2::Color{0.75, 0, 0})) << statements;
  };
  for (const char* name :
       {"x.mtl", ".\\x.mtl", "parts\\x.mtl", "parts\\deep\\my x.mtl", "my x.mtl", "a #1.mtl",
        "x.mtl # from the catalogue", "parts\\x.mtl\t# 7", "my x.mtl # x", "y.mtl .\\x.mtl # both", "x.mtl x.mtl"})
    finds("mtllib " + std::string(name) + "\n");
  finds("mtllib x.mtl\nmtllib x.mtl\nmtllib .\\x.mtl\nmtllib ./x.mtl\n");
}

TEST(Models, OptionsOfATextureMayStandBehindItsName) {
  const Folder folder;
  for (const char* name : {"a.ppm", "my a.ppm", "-s 2.ppm", "a -s x.ppm"}) folder.Write(name, "P3 1 1 255 51 0 0\n");
  folder.Write("a.obj", "mtllib a.mtl\n" + triangle + "vt 1 1\nusemtl a\nf 1/1 2/1 3/1\n");
  const auto uv_of = [&](const std::string& map) {
    folder.Write("a.mtl", "newmtl a\nmap_Kd " + map + "\n");
    const ParsedScene parsed = Parse(folder / "a.obj", {});
    EXPECT_TRUE(parsed.warnings.empty()) << parsed.warnings[0];
    EXPECT_TRUE(MaterialsOf(folder, "a.obj").at(0).texture) << map;
    const auto& uv = dynamic_cast<const R3::Mesh&>(*parsed.scene.root.children.at(0).shape).Data().uvs.at(0);
    return std::pair(uv.x, uv.y);
  };
  EXPECT_EQ(uv_of("a.ppm -s 2 3"), std::pair(2., 3.));
  EXPECT_EQ(uv_of("my a.ppm -s 2 3 1 -o .5 0 0 -blendu on"), std::pair(2.5, 3.));
  EXPECT_EQ(uv_of("-s 2 3 a.ppm -o .5 .25 # moved"), std::pair(2.5, 3.25));
  EXPECT_EQ(uv_of("a.ppm # -s 2 2"), std::pair(1., 1.));
  EXPECT_EQ(uv_of("a -s x.ppm"), std::pair(1., 1.)) << "a name anyway";
  EXPECT_EQ(uv_of("./-s 2.ppm"), std::pair(1., 1.));
}

// 20,000 unknown names next to 20,000 known ones took 83 s. Counted, not timed: the suggestions took the time.
TEST(Models, ManyUnknownMaterialsAreSuggestedForTheFirstFewOnly) {
  const Folder folder;
  std::string library, mesh = "mtllib a.mtl\n" + triangle;
  for (int i = 0; i < 3000; ++i) {
    library += "newmtl material" + std::to_string(i) + "\n";
    mesh += "usemtl meterial" + std::to_string(i) + "\nf 1 2 3\n";
  }
  folder.Write("a.mtl", library);
  folder.Write("a.obj", mesh);
  const auto warnings = WarningsOf(folder, "a.obj");
  ASSERT_EQ(warnings.size(), 101u);
  EXPECT_EQ(warnings.back(), "and 2900 more warnings");
  const auto suggests = [](const std::string& warning) { return Contains(warning, "did you mean"); };
  EXPECT_EQ(std::ranges::count_if(warnings, suggests), 10);
}

TEST(Models, OnlyColorsWellAboveOneAreBytes) {
  const Folder folder;
  const auto first_of = [&](const std::string& color) {
    folder.Write("a.obj", "v 0 0 0 " + color + "\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
    return ColorsOf(folder, "a.obj").at(0);
  };
  EXPECT_EQ(first_of("1.000001 .5 .25"), (std::array{1.f, 0.5f, 0.25f})) << "rounded";
  EXPECT_EQ(first_of("1.5 .5 .25"), (std::array{1.f, 0.5f, 0.25f})) << "overexposed";
  EXPECT_EQ(first_of("51 102.5 255"), (std::array{0.2f, 102.5f / 255, 1.f}));
  EXPECT_EQ(first_of("51 0 2"), (std::array{0.2f, 0.f, 2 / 255.f}));
  EXPECT_EQ(first_of("2 1 0"), (std::array{2 / 255.f, 1 / 255.f, 0.f})) << "whole numbers above 1 are dark bytes";
  folder.Write("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "property float r\nproperty float g\nproperty float b\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n"
               "0 0 0 1.0000001 .5 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n");
  EXPECT_EQ(ColorsOf(folder, "a.ply").at(0), (std::array{1.f, 0.5f, 0.f})) << "named r g b";
  folder.Write("a.off", "COFF\n3 1 0\n0 0 0 1.001 .5 0 1\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(ColorsOf(folder, "a.off").at(0), (std::array{1.f, 0.5f, 0.f}));
}

/// Returns a text .ply file with face colors.
std::string PlyWithFaces(const std::string& of_vertices, const std::string& of_faces, const std::string& rows) {
  const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const auto count = std::ranges::count(rows, '\n');
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
         of_vertices + "element face " + std::to_string(count - 4) + "\nproperty list uchar int vertex_indices\n" +
         of_faces + colors + "end_header\n" + rows;
}

TEST(Models, OfPlyHaveTheColorsOfTheirFaces) {
  const Folder folder;
  folder.Write("a.ply", PlyWithFaces("property float nx\nproperty float ny\nproperty float nz\n", "",
                                     "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 1 0\n"
                                     "3 0 1 2 255 0 0\n3 1 3 2 0 0 255\n3 2 3 1 255 0 0\n"));
  const ParsedScene parsed = Parse(folder / "a.ply", {});
  EXPECT_TRUE(parsed.warnings.empty());
  const Node& node = parsed.scene.root.children.at(0);
  EXPECT_TRUE(parsed.scene.materials[static_cast<std::size_t>(node.material)].has_vertex_colors);
  const auto& data = dynamic_cast<const R3::Mesh&>(*node.shape).Data();
  ASSERT_EQ(data.triangles.size(), 3u);
  EXPECT_EQ(data.positions.size(), 7u) << "one for each place and color";
  const std::array<std::array<float, 3>, 3> expected{{{1, 0, 0}, {0, 0, 1}, {1, 0, 0}}};
  const std::array<std::array<R3::Point, 3>, 3> corners{
      {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, {{{0, 1, 0}, {1, 1, 0}, {1, 0, 0}}}}};
  for (std::size_t t = 0; t < 3; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = data.triangles[t][k];
      EXPECT_EQ(data.colors.at(vertex), expected[t]);
      EXPECT_EQ(data.positions[vertex], corners[t][k]);
      EXPECT_EQ(data.normals[vertex].y, data.positions[vertex].x * data.positions[vertex].y) << "its own";
    }
}

TEST(Models, OfPlyWithColorsOfVerticesIgnoreThoseOfFaces) {
  const Folder folder;
  const std::string places = "0 0 0 0 255 0\n1 0 0 0 255 0\n0 1 0 0 255 0\n1 1 0 0 255 0\n";
  folder.Write("a.ply", PlyWithFaces("property uchar r\nproperty uchar g\nproperty uchar b\n", "",
                                     places + "3 0 1 2 255 0 0\n"));
  EXPECT_EQ(ColorsOf(folder, "a.ply"), Colors(4, {0, 1, 0}));
}

TEST(Models, ColorsOfFacesGoWithTheirTextureCoordinates) {
  const Folder folder;
  folder.Write("a.ply", PlyWithFaces("", "property list uchar float texcoord\n",
                                     "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
                                     "3 0 1 2 6 0 0 1 0 0 1 255 0 0\n3 1 3 2 6 1 0 1 1 0 1 0 255 0\n"));
  const Scene scene = Parse(folder / "a.ply", {}).scene;
  const auto& data = dynamic_cast<const R3::Mesh&>(*scene.root.children.at(0).shape).Data();
  ASSERT_EQ(data.colors.size(), data.uvs.size());
  for (std::size_t t = 0; t < 2; ++t)
    for (const std::uint32_t vertex : data.triangles[t]) {
      EXPECT_EQ(data.colors[vertex][t], 1);
      EXPECT_EQ(data.uvs[vertex], (R2::Point{data.positions[vertex].x, data.positions[vertex].y}));
    }
}

TEST(Models, VertexColorsMultiplyKdOnRequest) {
  const Models models;
  const std::string scene =
      "camera 1 .5 50  0 0 -1  0 1 0  1e-6 .01 100\ndir_light 1 1 1 0 0 -1\nambient 1 1 1\n"
      "material .1 .1 .1  .8 .8 .8  0 0 0 0 0 0 0 0 0 1 1 0\nvertex_colors 0\n";
  const auto seen = [&](const std::string& more) {
    return project::Render(project::Stage(Parse(models.Write("scene.scn", scene + more), {}).scene), project::Sized(1))
        .image.At(0, 0);
  };
  const std::string mesh = "mesh 0 meshlab_colors.obj\n";
  ExpectColor(seen(mesh), {0.4 + 0.1, 0.4 + 0.1, 0.8 + 0.1});
  ExpectColor(seen("texture_ambient 0\n" + mesh), {0.4 + 0.05, 0.4 + 0.05, 0.8 + 0.1});
  ExpectColor(seen("sphere 0 1 .5 0 1\n"), {0.9, 0.9, 0.9});  // other shapes have none
}

}  // namespace
}  // namespace ray

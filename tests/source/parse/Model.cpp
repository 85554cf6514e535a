// Models with the materials of their files. models/make.py wrote those of Blender, MeshLab and SketchUp, after these
// programs' documentation; the colors expected are derived here from the numbers that it writes.

#include "source/parse/Model.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "R3/Mesh.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

std::string BytesOf(const fs::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

/// A folder with copies of the models, for scenes of them.
struct Models : Folder {
  Models() {
    const fs::path from = ProjectRoot() / "tests/source/parse/models";
    for (const auto& entry : fs::recursive_directory_iterator(from))
      if (entry.is_regular_file()) Write(entry.path().lexically_relative(from).string(), BytesOf(entry.path()));
  }

  /// What is seen along -z at a place of a model in front of gray, in light along -z.
  R2::Color SeenAt(const std::string& model, double x, double y, const std::string& how = "materials") const {
    std::ostringstream scene;
    scene << "camera " << x << ' ' << y << " 50  0 0 -1  0 1 0  1e-6 .01 100\nbackground .4 .4 .4\n"
          << "dir_light 1 1 1  0 0 -1\nmaterial 0 0 0  0 .5 0  0 0 0  0 0 0  0 0 0  1 1 0\nmesh 0 " << model << ' '
          << how << '\n';
    RenderSettings settings;
    settings.width = settings.height = 1;
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
  // Flat, its faces lean by 54.7 degrees, whose cosine is 1 / sqrt(3).
  const double cosine = 1 / std::sqrt(3);
  ExpectColor(models.SeenAt("blender_box.obj", 3.2, 1.2), {0.05 * cosine, 0.2 * cosine, 0.7 * cosine}, 1e-4);
}

TEST(Models, OfBlenderTransmitEmitMirrorAndHaveNormalMaps) {
  const Models models;
  // d .25: a quarter of kd, and three quarters of what is behind, through both sides; the back is in shadow.
  const double behind = 0.75 * 0.75 * 0.4;
  ExpectColor(models.SeenAt("blender_glass.obj", 0, 1), {0.05 + behind, 0.2 + behind, 0.1 + behind});
  ExpectColor(models.SeenAt("blender_lamp.obj", 0.5, 0.5), {0.9, 0.6, 0.3});
  ExpectColor(models.SeenAt("blender_glass.obj", -2.5, 0.5), {0.1 + 0.28, 0.1 + 0.24, 0.1 + 0.16});
  // 204, 128 and 230 255ths are 2 c - 1 = .6, .004 and .804, whose unit vector leans by a cosine of .8014.
  ExpectColor(models.SeenAt("blender_glass.obj", -2.5, 2), {0.4007, 0.4007, 0.4007}, 1e-4);
}

TEST(Models, OfMeshLabHaveTheColorsOfTheirVertices) {
  const Models models;
  for (const double x : {0.25, 1.0, 1.5})
    for (const double y : {0.25, 0.5, 0.9})
      ExpectColor(models.SeenAt("meshlab_colors.obj", x, y), {x / 2, y, 1});  // as at the corners, and even between
}

TEST(Models, OfMeshLabHaveSeveralTextures) {
  const Models models;
  // Tr .5 halves kd .5 1 1; blue and white squares of the image. The sides behind are in shadow, seen through half of
  // the front, and let half of the half through.
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
  // White sides, brick walls, the roof that no library has, and glass, half of whose .6 is seen.
  EXPECT_EQ(greens, (std::vector<double>{1, 0.270588, 0.5, 0.3}));
}

// Course files say a material for every mesh, and mean it.
TEST(Models, WithoutTheKeywordAMeshHasTheScenesMaterial) {
  const Models models;
  const Scene scene =
      Parse(models.Write("scene.scn", red + "mesh 0 blender_glass.obj\nmesh 0 meshlab_colors.obj\n"), {}).scene;
  ASSERT_EQ(scene.root.children.size(), 2u);
  EXPECT_EQ(scene.root.children[0].material, 1);
  ExpectColor(models.SeenAt("meshlab_colors.obj", 0.25, 0.5, ""), {0, 0.5, 0});
}

TEST(Models, ThatStayGrayThoughTheirFileSaysMoreAreTold) {
  const Models models;
  const auto warnings = [&](const std::string& scene) { return Parse(models.Write("scene.scn", scene), {}).warnings; };
  const auto gray = warnings("mesh -1 blender_box.obj\n");
  ASSERT_EQ(gray.size(), 1u);
  EXPECT_TRUE(gray[0].ends_with(
      "scene.scn:1:1: warning: the mesh is gray; 'materials' behind its name shows those of its file"))
      << gray[0];
  EXPECT_EQ(warnings("mesh -1 meshlab_colors.obj\n").size(), 1u);
  EXPECT_TRUE(warnings("mesh -1 blender_box.obj materials\n").empty());
  EXPECT_TRUE(warnings(red + "mesh 0 blender_box.obj\n").empty());
  EXPECT_TRUE(warnings(red + "begin 0" + identity + "mesh -1 blender_box.obj\nend\n").empty());
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

/// The warnings about a file, without the folder.
std::vector<std::string> WarningsOf(const Folder& folder, const std::string& name) {
  std::vector<std::string> warnings = Parse(folder / name, {}).warnings;
  const std::string prefix = folder.Path().string() + "/";
  for (std::string& warning : warnings)
    for (std::size_t i; (i = warning.find(prefix)) != std::string::npos;) warning.erase(i, prefix.size());
  return warnings;
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Models, WhatTheirLibrariesLackIsTold) {
  const Folder folder;
  folder.Write("a.mtl", "newmtl red\nKd 1 0 0\nmap_Kd my wod.png\n");
  folder.Write("my wood.png", "no image");
  folder.Write("a.obj", "mtllib b.mtl a.mtl\n" + triangle + "usemtl red\nf 1 2 3\n");
  EXPECT_EQ(WarningsOf(folder, "a.obj"),
            (std::vector<std::string>{
                "a.obj:1:8: warning: no such file: 'b.mtl'; its materials are gray",
                "a.mtl:3:8: warning: no such file: 'my wod.png'; the material is left without it; did you mean "
                "'my wood.png'?"}));
  folder.Write("b.obj", "mtllib a.mtl\n" + triangle + "usemtl rde\nf 1 2 3\n");
  EXPECT_EQ(
      WarningsOf(folder, "b.obj"),
      std::vector<std::string>{"b.obj:5:8: warning: unknown material 'rde'; its faces are gray; did you mean 'red'?"});
  folder.Write("c.obj", triangle + "usemtl None\nf 1 2 3\n");
  EXPECT_TRUE(WarningsOf(folder, "c.obj").empty());
}

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
  EXPECT_EQ(MaterialOf("d .5\nNi 1.5\n").ir, 1) << "what is dissolved does not bend light";
  EXPECT_EQ(MaterialOf("Tr .5\n").kt, half);
  EXPECT_EQ(MaterialOf("d 1\nTr 1\n").kt, none) << "d counts";
  EXPECT_EQ(MaterialOf("Tf 1 1 1\nillum 4\n").kt, none) << "programs write it for what is opaque";
  EXPECT_EQ(MaterialOf("d .5\nTf 1 0 0\n").kt, (R2::Color{0.5, 0, 0}));
  const Material glass = MaterialOf("Kd 0 0 0\nTf .9 .8 .7\nNi 1.5\nillum 7\n");
  EXPECT_EQ(glass.kt, (R2::Color{0.9, 0.8, 0.7}));
  EXPECT_EQ(glass.ir, 1.5);
}

TEST(Models, WhatMaterialsSayBeyondThatIsToldWithItsPlace) {
  const Folder folder;
  folder.Write("gray.ppm", "P3 1 1 255 128 128 128\n");
  folder.Write("a.mtl",
               "Kd 1 1 1\nnewmtl a\nmap_Ks gray.ppm\nPr .5\nKs spectral a.rfl\nmap_Ka gray.ppm\n"
               "map_Kd -blendu on -mm 0 1 -clamp on gray.ppm\nmap_bump -bm 2 gray.ppm\nd -halo .5\nfoo\n"
               "newmtl b\n Pr .6\nnewmtl c\nPr .7\n");
  folder.Write("a.obj", "mtllib a.mtl\n" + triangle + "vt 0 0\nvt 2 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(WarningsOf(folder, "a.obj"),
            (std::vector<std::string>{
                "a.mtl:1:1: warning: 'Kd' before the first newmtl ignored",
                "a.mtl:3:1: warning: 'map_Ks' is not supported and ignored",
                "a.mtl:4:1: warning: 'Pr' is not supported and ignored, 3 times, the first of them here",
                "a.mtl:5:4: warning: a color must be r g b; 'spectral' is not supported and ignored",
                "a.mtl:7:19: warning: '-mm' is not supported and ignored",
                "a.mtl:9:3: warning: '-halo' is not supported and ignored",
                "a.mtl:10:1: warning: 'foo' is not supported and ignored",
                "a.mtl:7:37: warning: '-clamp on' is not supported: the texture repeats"}));
  const Scene scene = Parse(folder / "a.obj", {}).scene;
  const Material& a = scene.materials.at(static_cast<std::size_t>(scene.root.children.at(0).material));
  EXPECT_TRUE(a.bump);
  EXPECT_DOUBLE_EQ(a.bump_height, 0.02);  // -bm 2, a hundredth of the extent
}

TEST(Models, MistakesInALibraryAreErrorsInIt) {
  const auto error = [](const std::string& statements) {
    const Folder folder;
    folder.Write("a.mtl", "newmtl a\n" + statements);
    folder.Write("a.obj", "mtllib a.mtl\n" + triangle + "usemtl a\nf 1 2 3\n");
    const std::string report = ReportOf(folder, "a.obj");
    return report.substr(0, report.find('\n'));
  };
  EXPECT_EQ(error("Kd 1 x 0\n"), "a.mtl:2:6: error: Kd must be a number, got 'x'");
  EXPECT_EQ(error("Kd 1 0\n"), "a.mtl:2:6: error: Kd: a number is missing");
  EXPECT_EQ(error("Kd -1 0 0\n"), "a.mtl:2:4: error: Kd must not be negative, got -1");
  EXPECT_EQ(error("Ns 1.#QNAN\n"), "a.mtl:2:4: error: Ns must be a finite number, got '1.#QNAN'");
  EXPECT_EQ(error("illum 2.5\n"), "a.mtl:2:7: error: illum must be a whole number from 0 to 10, got 2.5");
  EXPECT_EQ(error("map_Kd\n"), "a.mtl:2:1: error: map_Kd: the file is missing");
  EXPECT_EQ(error("map_Kd -foo 1 a.png\n"), "a.mtl:2:8: error: unknown option '-foo' of a texture");
  EXPECT_EQ(error("newmtl\n"), "a.mtl:2:1: error: the material's name is missing");
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
  EXPECT_EQ(kd_and_color("", bytes, "1 1 0").second, (std::array{1 / 255.f, 1 / 255.f, 0.f})) << "bytes all the same";
  const std::string floats = "property float red\nproperty float green\nproperty float blue\n";
  EXPECT_EQ(kd_and_color("", floats, ".25 .5 1").second, (std::array{0.25f, 0.5f, 1.f}));
  EXPECT_EQ(kd_and_color("", floats, "51 102 255").second, (std::array{0.2f, 0.4f, 1.f})) << "more than 1 is of 255";
  const std::string shorts = "property ushort red\nproperty ushort green\nproperty ushort blue\n";
  EXPECT_EQ(kd_and_color("", shorts, "13107 0 65535").second, (std::array{0.2f, 0.f, 1.f}));
  EXPECT_EQ(kd_and_color("comment TextureFile a.ppm\n", "property float s\nproperty float t\n", "0 0").first[1],
            double{102 / 255.f});
}

TEST(Models, ColorsOfVerticesThatAreNoneAreWhite) {
  const Folder folder;
  folder.Write("a.obj", "v 0 0 0 .25 .5 .75\nv 1 0 0\nv 0 1 0 nan 0 0\nv 1 1 0 0 -1 0\nf 1 2 4 3\n");
  const ParsedScene parsed = Parse(folder / "a.obj", {});
  const auto& data = dynamic_cast<const R3::Mesh&>(*parsed.scene.root.children.at(0).shape).Data();
  const std::array<float, 3> white{1, 1, 1};
  EXPECT_EQ(data.colors, (std::vector<std::array<float, 3>>{{0.25f, 0.5f, 0.75f}, white, white, white}));
  ASSERT_EQ(parsed.warnings.size(), 1u);
  EXPECT_TRUE(Contains(parsed.warnings[0], "a.obj:3:9: warning: 2 colors of vertices are not finite or negative"));
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

TEST(Models, VertexColorsMultiplyKdWhereAskedFor) {
  const Models models;
  const std::string scene =
      "camera 1 .5 50  0 0 -1  0 1 0  1e-6 .01 100\ndir_light 1 1 1 0 0 -1\nambient 1 1 1\n"
      "material .1 .1 .1  .8 .8 .8  0 0 0 0 0 0 0 0 0 1 1 0\nvertex_colors 0\n";
  const auto seen = [&](const std::string& more) {
    RenderSettings settings;
    settings.width = settings.height = 1;
    return project::Render(project::Stage(Parse(models.Write("scene.scn", scene + more), {}).scene), settings)
        .image.At(0, 0);
  };
  const std::string mesh = "mesh 0 meshlab_colors.obj\n";
  ExpectColor(seen(mesh), {0.4 + 0.1, 0.4 + 0.1, 0.8 + 0.1});
  ExpectColor(seen("texture_ambient 0\n" + mesh), {0.4 + 0.05, 0.4 + 0.05, 0.8 + 0.1});
  ExpectColor(seen("sphere 0 1 .5 0 1\n"), {0.9, 0.9, 0.9});  // other shapes have none
}

}  // namespace
}  // namespace ray

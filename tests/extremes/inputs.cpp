// What scenes and files from strangers may say.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <thread>

#include "R3/Mesh.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/SceneSettings.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

ParsedScene ParsedFrom(const TemporaryFolder& folder, const std::string& text) {
  return Parse(WriteFile(folder / "in.scn", text), {});
}

std::string ErrorOf(const TemporaryFolder& folder, const std::string& text) {
  return project::MessageOf<SceneErrors>([&] { ParsedFrom(folder, text); });
}

TEST(Extremes, A5_ASqueezeIsSilentThenWarnedOfThenLeftOut) {
  const TemporaryFolder folder;
  for (int k = 2; k <= 16; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const std::string small = "1e-" + std::to_string(k);
      const auto scale = [&](int i) { return i == axis ? small : std::string("1"); };
      const ParsedScene parsed = ParsedFrom(folder, "begin -1\n" + scale(0) + " 0 0 0\n0 " + scale(1) + " 0 0\n0 0 " +
                                                        scale(2) + " 0\n0 0 0 1\nsphere -1 0 0 0 1\nend\n");
      const World world(parsed.scene);
      EXPECT_EQ(world.Instances().size(), k <= 14 ? 1u : 0u) << k;
      ASSERT_EQ(parsed.warnings.size(), k <= 10 ? 0u : 1u) << k;
      for (const std::string& warning : parsed.warnings)
        EXPECT_NE(warning.find("in.scn:1:"), std::string::npos) << warning;
    }
}

TEST(Extremes, B10_ZeroSizeSpheresAreMissedAndNegativeOnesRefused) {
  const TemporaryFolder folder;
  for (const char* radius : {"0", "-0", "1e-300"}) {
    const ParsedScene parsed = ParsedFrom(folder, std::string("sphere -1 0 0 0 ") + radius + "\n");
    const bool has_size = std::string(radius) == "1e-300";
    EXPECT_EQ(parsed.warnings.empty(), has_size) << radius;
    const World world(parsed.scene);
    for (const char* kind : {"none", "bvh", "grid", "octree", "graph"}) {
      const auto accelerator = FindAcceleratorKind(kind)->Make(world, {.name = kind});
      Workspace workspace;
      EXPECT_FALSE(accelerator->Intersect({{1e-3, 0, 5}, {0, 0, -1}}, workspace)) << radius << kind;
      EXPECT_EQ(accelerator->Intersect({{0, 0, 5}, {0, 0, -1}}, workspace).has_value(), has_size) << radius << kind;
    }
  }
  for (const char* radius : {"-1", "-1e-300", "nan", "-nan", "inf", "1e400"})
    EXPECT_NE(ErrorOf(folder, std::string("sphere -1 0 0 0 ") + radius + "\n").find("in.scn:1:17: error"),
              std::string::npos)
        << radius;
}

/// A triangle in z = 0 with its front to +z, as .obj, and what is said behind its vertices.
std::string Triangle(const std::string& normals, const std::string& uvs = "vt 0 0\nvt 1 0\nvt 0 1\n") {
  return "v -1 -1 0\nv 1 -1 0\nv 0 1 0\n" + uvs + normals + "f 1/1/1 2/2/2 3/3/3\n";
}

TEST(Extremes, D11_ZeroNormalsUseFacesAndWrongOnesAddNoLight) {
  const TemporaryFolder folder;
  const std::string scene =
      "camera 0 0 4 0 0 -1 0 1 0 .3 .1 9\nmaterial 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0\n"
      "mesh 0 a.obj smooth\ndir_light 1 1 1 ";
  const auto shown = [&](const std::string& normals, const char* light, bool shadows) {
    WriteFile(folder / "a.obj", Triangle(normals));
    const project::Stage stage(ParsedFrom(folder, scene + light + "\n").scene);
    RenderSettings settings = project::Sized(9);
    settings.trace.shadows = shadows;
    return project::Render(stage, settings).image.At(4, 4).g;
  };
  const std::string zero = "vn 0 0 0\nvn 0 0 0\nvn 0 0 0\n", opposite = "vn 0 0 -1\nvn 0 0 -1\nvn 0 0 -1\n",
                    cancelling = "vn 0 0 1\nvn 0 0 -1\nvn 0 0 0\n";
  for (const bool shadows : {true, false}) {
    EXPECT_NEAR(shown(zero, "0 0 -1", shadows), 1, 1e-6);
    EXPECT_NEAR(shown(opposite, "0 0 -1", shadows), 1, 1e-6);  // its corners turn clockwise round its normals
    EXPECT_TRUE(std::isfinite(shown(cancelling, "0 0 -1", shadows)));
    for (const std::string& normals : {zero, opposite, cancelling})
      EXPECT_EQ(shown(normals, "0 0 1", shadows), 0) << normals;  // from behind
  }
  for (const char* bad : {"nan", "inf", "1e400"}) {
    WriteFile(folder / "a.obj", Triangle(std::string("vn 0 0 1\nvn 0 ") + bad + " 1\nvn 0 0 1\n"));
    const std::vector<std::string> warnings = ParsedFrom(folder, scene + "0 0 -1\n").warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(warnings[0].ends_with("a.obj:10:9: warning: 1 use of a normal that is not finite is ignored"));
  }
}

TEST(Extremes, D13_HugeTextureCoordinatesWrapAndNonFiniteOnesAreZero) {
  const TemporaryFolder folder;
  fs::copy_file(project::Root() / "scenes" / "textures" / "checker.png", folder / "t.png");
  const std::string scene =
      "camera 0 0 4 0 0 -1 0 1 0 .3 .1 9\nmaterial 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 t.png\nmesh 0 a.obj\n"
      "dir_light 1 1 1 0 0 -1\n";
  const std::string flat = "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\n";
  for (const char* uvs : {"vt 1e9 0\nvt -1e9 0\nvt 0 1e9\n", "vt -1e9 -1e9\nvt -1e9 -1e9\nvt -1e9 -1e9\n",
                          "vt 1e150 0\nvt -1e150 1e150\nvt 0 0\n"}) {
    WriteFile(folder / "a.obj", Triangle(flat, uvs));
    const project::Stage stage(ParsedFrom(folder, scene).scene);
    int lit = 0;
    const R2::Image image = project::Render(stage, project::Sized(16)).image;
    for (const float x : image.Channels()) {
      ASSERT_TRUE(x >= 0 && x <= 1) << uvs;  // a color of the texture
      lit += x > 0;
    }
    EXPECT_GT(lit, 0) << uvs;
  }
  for (const char* bad : {"nan", "inf", "1e400"}) {
    WriteFile(folder / "a.obj", Triangle(flat, std::string("vt 0 0\nvt ") + bad + " 0\nvt 0 1\n"));
    const std::vector<std::string> warnings = ParsedFrom(folder, scene).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(
        warnings[0].ends_with("a.obj:10:9: warning: 1 use of texture coordinates that are not finite counts as 0 0"));
  }
}

// What is read and written, and how long it takes, is the user's alone.
TEST(Extremes, K12_ASceneSetsNothingThatReadsWritesOrRunsAnything) {
  for (const OptionKind& option : OptionTable(Program::raypro)) {
    const std::string topic = option.topic;
    const bool is_of_image = topic == "image" || topic == "light" || topic == "view";
    const bool names_files = std::holds_alternative<FileName>(option.value) ||
                             std::holds_alternative<FileList>(option.value) ||
                             std::holds_alternative<Repeated>(option.value) || !IsSetting(option);
    if (is_of_image && !names_files) continue;
    for (const char* value : {"1", "on", "x.ppm", "", "|sh", "$(touch x)"})
      EXPECT_TRUE(ProblemOf({option.name, value, "in.scn:1"})) << option.name << ' ' << value;
  }
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  for (const char* setting : {"report r.json", "checkpoint 1s", "threads 1", "allow_path /", "replay r.json", "resume",
                              "reference a.png", "convert b.scn", "info a.png", "memory 1"}) {
    WriteFile(folder / "in.scn", std::string("set ") + setting + "\nsphere -1 0 0 0 1\n");
    const Finished done = RunProgram({folder / "in.scn", folder / "out.ppm", "-width", "8", "-height", "8"});
    EXPECT_EQ(done.status, 3) << setting;
    EXPECT_EQ(folder.Others({"in.scn"}), std::vector<std::string>{}) << setting;
  }
}

TEST(Extremes, K15_ImagesTooLargeToWriteAreRefusedBeforeRendering) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  WriteFile(folder / "in.scn", "sphere -1 0 0 0 1\n");
  for (const R2::ImageFormat& format : R2::ImageFormats())
    for (const auto& [width, height] : {std::pair{"50000", "85899"},
                                        {"46341", "46341"},
                                        {"65536", "65536"},
                                        {"1073741824", "4"},
                                        {"1073741824", "1073741824"},
                                        {"4", "1073741824"}}) {
      const Finished done = RunProgram({folder / "in.scn", folder / (std::string("out.") + format.extensions[0]),
                                        "-width", width, "-height", height, "-quiet"});
      EXPECT_EQ(done.status, 2) << format.name << ' ' << width << 'x' << height << done.error;
      EXPECT_EQ(folder.Others({"in.scn"}), std::vector<std::string>{});
    }
}

// A file that shrinks while it is mapped kills who reads it.
TEST(Extremes, L4_AFileShrinkingWhileReadIsWholeOrAnError) {
  const TemporaryFolder folder;
  std::string mesh = "OFF 100000 1 0\n";
  for (int i = 0; i < 100'000; ++i) mesh += std::to_string(i) + " 1 " + std::to_string(i % 7) + "\n";
  mesh += "3 0 1 2\n";
  // Twelve times, and on until the file has shrunk under a reader: a busy machine may let the reader pass first.
  int failed = 0;
  for (int round = 0; round < 12 || (failed == 0 && round < 1000); ++round) {
    WriteFile(folder / "a.off", mesh);
    std::atomic<bool> is_running = false, is_over = false;
    std::thread other([&] {
      is_running = true;
      std::this_thread::sleep_for(std::chrono::microseconds(100 * (round % 12)));
      std::error_code ignored;
      for (std::size_t size = mesh.size(); !is_over && size > 4096; size /= 2)
        fs::resize_file(folder / "a.off", size / 2, ignored);
      if (round % 2) fs::remove(folder / "a.off", ignored);
    });
    while (!is_running) std::this_thread::yield();
    failed += !ErrorOf(folder, "mesh -1 a.off\n").empty();
    is_over = true;
    other.join();
  }
  EXPECT_GT(failed, 0);
  fs::remove(folder / "a.off");
  EXPECT_NE(ErrorOf(folder, "mesh -1 a.off\n").find("no such file"), std::string::npos);
}

}  // namespace
}  // namespace ray::testing

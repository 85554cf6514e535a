#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <tuple>

#include "R2/Image.h"
#include "R2/ImageFile.h"
#include "tests/Display.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

// The real program, which draws without a window unless the window itself is tested.
namespace ray {
namespace {

using testing::Finished;
using testing::ReadFile;
using testing::TemporaryFolder;
using testing::WriteFile;

std::string Scene(const std::string& name) {
  return std::filesystem::canonical(project::Root() / "scenes" / name).string();
}

R2::Image ImageFrom(const std::string& file) { return testing::Decode(file).image; }

// For programs built with a leak detector: GLX and OSMesa keep memory to the end, EGL does not.
constexpr const char* drivers_leak = "detect_leaks=0";

class Rayview : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::ProgramName("RAYVIEW")) GTEST_SKIP() << "rayview is not built here: nothing to draw with";
    const Finished trial = Run({Scene("empty.scn"), "-headless"});
    if (trial.status == 1) GTEST_SKIP() << "this machine cannot draw: " << trial.error;
  }
  Finished Run(const std::vector<std::string>& words) const {
    return testing::RunProgram(words, {.program = "RAYVIEW", .environment = environment});
  }
  /// Runs a script without a window.
  Finished Follow(const std::string& scene, const std::string& script, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {scene, "-headless", "-events", WriteFile(folder / "script.events", "origin bottom\n" + script), "-width",
                               "96", "-height", "64"});
    return Run(more);
  }

  TemporaryFolder folder;
  std::map<std::string, std::string> environment;
};

// Scripts behave the same for every user.
TEST_F(Rayview, ScriptsNeitherUseNorChangeAUsersPreferences) {
  environment["XDG_CONFIG_HOME"] = folder / "config";
  std::filesystem::create_directories(folder / "config/raypro");
  const std::string habits = WriteFile(folder / "config/raypro/rayview", "theme pink\n");
  const Finished viewed = Follow(Scene("hello.scn"), "resize 800 800\nkey Tab\n", {"-quiet"});
  EXPECT_EQ(viewed.status, 0);
  EXPECT_EQ(viewed.error.find("cannot be parsed"), std::string::npos) << viewed.error;
  EXPECT_EQ(ReadFile(habits), "theme pink\n");
}

TEST_F(Rayview, KeySWritesTheBytesThatRayproWrites) {
  for (const char* scene : {"hello.scn", "area_light.scn", "glass.scn", "texture.scn"}) {
    const Finished viewed = Follow(Scene(scene), "key S\nwait trace\n", {"-image", folder / "view.ppm"});
    ASSERT_EQ(viewed.status, 0) << viewed.error;
    const Finished rendered =
        testing::RunProgram({Scene(scene), folder / "pro.ppm", "-width", "96", "-height", "64", "-quiet"});
    ASSERT_EQ(rendered.status, 0) << rendered.error;
    EXPECT_EQ(ReadFile(folder / "view.ppm"), ReadFile(folder / "pro.ppm")) << scene;
  }
}

// What a window shows at rest is what an image file would hold, of every kind of scene and course.
TEST_F(Rayview, TheTracedImageHasTheBytesOfRaypro) {
  const std::vector<std::string> scenes{
      "area_light.scn", "bezier.scn",       "blob.scn",           "bump.scn",           "camera_motion.scn", "coat.scn",
      "cornell.scn",    "csg.scn",          "drink.scn",         "emissive.scn",      "environment.scn",
      "fisheye.scn",    "globe.yaml",       "gooch.yaml",         "hatching.scn",       "hierarchy.scn",     "implicit.scn",
      "adaptive.yaml",  "lens.scn",         "spot_light.scn",     "many_lights.scn",    "mirrors.json",      "motion.scn",
      "normal_map.scn", "pearls.json",      "smooth.scn",         "texture.scn",        "groningen/csg.yaml", "comp30019/room.txt",
      "zbuffer.yml",    "groningen/fisheye.yaml"};
  for (const std::string& scene : scenes) {
    const std::vector<std::string> options{"-width", "40", "-height", "30", "-samples", "4", "-shadow_samples", "1", "-quiet"};
    const Finished viewed = Run(testing::With({Scene(scene), "-headless", "-exit_immediately", "-preview", "traced",
                                               "-output_image", folder / "view.ppm"},
                                              options));
    ASSERT_EQ(viewed.status, 0) << viewed.error;
    ASSERT_EQ(testing::RunProgram(testing::With({Scene(scene), folder / "pro.ppm"}, options)).status, 0) << scene;
    EXPECT_TRUE(ReadFile(folder / "view.ppm") == ReadFile(folder / "pro.ppm")) << scene;
  }
}

TEST_F(Rayview, AClickWhereNoRayIsHarmsNothing) {
  for (const char* scene : {"fisheye.scn", "groningen/fisheye.yaml", "camera_motion.scn", "empty.scn"}) {
    const Finished viewed =
        Follow(Scene(scene), "wait image\nclick left 1 1\nclick right 1 1\nclick left 1 1\nkey Tab\nkey K\nkey X\n"
                             "move 1 1\nkey G\nkey Backspace\nprint\n");
    EXPECT_EQ(viewed.status, 0) << scene << viewed.error;
    EXPECT_NE(viewed.output.find("scene "), std::string::npos) << scene;
  }
}

// Three mistakes of a student's tracer, found by one printf: what its lines are is computed by hand.
TEST_F(Rayview, MistakesOfAnotherTracerAreNamedByItsRays) {
  const std::string scene = WriteFile(
      folder / "ball.scn",
      "camera 0 1 6  0 0 -1  0 1 0  0.4  0.01 100\npoint_light 1 1 1  3 5 6  1 0 0\n"
      "material 0.1 0.1 0.1  0 0 0  0 0 0  0.9 0.9 0.9  0 0 0  10 1.5 0\nsphere 0  0 1 0  1\n");
  const std::string pixel = "pixel 44 30\n", camera = "camera 0 1 6  0.23922 1.0266 0.9706\n",
                    from = "0.23922 1.0266 0.9706  ";
  for (const auto& [rays, verdict] :
       {std::pair{pixel + camera + "transmission " + from + "0.3295 1.03663 -0.9272\n", "it goes straight on"},
        {pixel + camera + "transmission " + from + "0.53784 1.05978 -0.49901\n", "refraction with eta inverted"},
        {pixel + "camera 0 1 6  0.114 1.01265 1\n", "the half angle is taken for the whole one"}}) {
    const Finished viewed = Run({scene, "-headless", "-rays", WriteFile(folder / "mine.rays", rays), "-width", "80",
                                 "-height", "60", "-events", WriteFile(folder / "print.events", "print\n")});
    EXPECT_EQ(viewed.status, 0) << viewed.error;
    EXPECT_NE(viewed.output.find(verdict), std::string::npos) << verdict << "\n" << viewed.output;
  }
  const Finished wrong =
      Run({scene, "-headless", "-rays", WriteFile(folder / "mine.rays", camera + "shadw 0 0 0  1 1 1\n")});
  EXPECT_EQ(wrong.status, 3);
  EXPECT_NE(wrong.error.find("mine.rays:2:1: error: 'shadw' is no kind of ray"), std::string::npos) << wrong.error;
  EXPECT_EQ(Run({scene, "-headless", "-rays", folder / "none.rays"}).status, 3);
}

// Settings of the previous scene are discarded, typed settings stay.
TEST_F(Rayview, ASceneThatIsReadLaterUsesItsOwnSettings) {
  for (const auto& [first, then] : {std::pair{"hello.scn", "toon.scn"}, {"toon.scn", "first.scn"}}) {
    const Finished viewed = Follow(Scene(first), "drop " + Scene(then) + "\nkey S\nwait trace\n",
                                   {"-image", folder / "view.ppm", "-samples", "2"});
    ASSERT_EQ(viewed.status, 0) << viewed.error;
    const Finished rendered = testing::RunProgram(
        {Scene(then), folder / "pro.ppm", "-width", "96", "-height", "64", "-samples", "2", "-quiet"});
    ASSERT_EQ(rendered.status, 0) << rendered.error;
    EXPECT_EQ(ReadFile(folder / "view.ppm"), ReadFile(folder / "pro.ppm")) << then;
  }
}

TEST_F(Rayview, AReloadedSceneHasItsCurrentSettings) {
  const std::string scene = WriteFile(folder / "now.scn", ReadFile(Scene("sphere.scn")) + "\nset mode flat\n");
  const Finished viewed =
      Follow(scene, "key Control+R\nkey S\nwait trace\n", {"-image", folder / "view.ppm", "-quiet"});
  ASSERT_EQ(viewed.status, 0) << viewed.error;
  ASSERT_EQ(testing::RunProgram({scene, folder / "pro.ppm", "-width", "96", "-height", "64", "-quiet"}).status, 0);
  EXPECT_EQ(ReadFile(folder / "view.ppm"), ReadFile(folder / "pro.ppm"));
}

TEST_F(Rayview, OptionsOfRayproMakeTheImageOfRaypro) {
  const std::vector<std::string> options{"-mode",    "path",  "-samples", "3",     "-filter",
                                         "mitchell", "-seed", "7",        "-quiet"};
  std::vector<std::string> view = options, pro = options;
  view.insert(view.begin(), {"-image", folder / "view.ppm"});
  pro.insert(pro.begin(), {Scene("indirect.scn"), folder / "pro.ppm", "-width", "96", "-height", "64"});
  EXPECT_EQ(Follow(Scene("indirect.scn"), "key S\nwait trace\n", view).status, 0);
  EXPECT_EQ(testing::RunProgram(pro).status, 0);
  EXPECT_EQ(ReadFile(folder / "view.ppm"), ReadFile(folder / "pro.ppm"));
}

TEST_F(Rayview, ThePrintedCameraReloadsToTheImage) {
  const Finished moved =
      Follow(Scene("hello.scn"), "drag left 20 20 60 33\nscroll 3 40 30\nkey [\nkey Space\nkey S\nwait trace\n",
             {"-image", folder / "moved.ppm", "-quiet"});
  ASSERT_EQ(moved.status, 0) << moved.error;
  const std::string line = moved.output.substr(0, moved.output.find('\n'));
  ASSERT_EQ(line.find("camera "), 0u) << moved.output;
  std::string text = ReadFile(Scene("hello.scn"));
  const std::size_t own = text.find("\ncamera ");
  ASSERT_NE(own, std::string::npos);
  text.replace(own + 1, text.find('\n', own + 1) - own - 1, line);
  std::filesystem::copy(std::filesystem::path(Scene("hello.scn")).parent_path(), folder.Path(),
                        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  const std::string scene = WriteFile(folder / "again.scn", text);
  const Finished again = testing::RunProgram({scene, folder / "again.ppm", "-width", "96", "-height", "64", "-quiet"});
  ASSERT_EQ(again.status, 0) << again.error;
  EXPECT_EQ(ReadFile(folder / "moved.ppm"), ReadFile(folder / "again.ppm"));
}

// An image must not replace a texture of the first scene or of one that was opened later.
TEST_F(Rayview, NoImageOverwritesAFileOfTheScene) {
  const std::string texture = folder / "texture.ppm", pixel = "P3 1 1 255 9 9 9\n";
  const std::string textured =
      WriteFile(folder / "textured.scn", "material 1 1 1 1 1 1 0 0 0 0 0 0 0 0 0 9 1 texture.ppm\nsphere 0 0 0 0 1\n");
  const std::string plain = WriteFile(folder / "plain.scn", testing::small_scene);
  WriteFile(texture, pixel);
  const std::string drop = "drop " + textured + "\n", trace = "key S\nwait trace\n";
  for (const auto& [scene, script, more] :
       {std::tuple{textured, "screenshot " + texture + "\n", std::vector<std::string>{}},
        {plain, drop + "screenshot " + texture + "\n", {}},
        {plain, drop + trace, {"-image", texture}},
        {plain, drop, {"-screenshot", texture}}}) {
    const Finished viewed = Follow(scene, script, more);
    EXPECT_EQ(viewed.status, 4) << script;
    EXPECT_NE(viewed.error.find("is the input"), std::string::npos) << viewed.error;
    EXPECT_EQ(ReadFile(texture), pixel) << script;
  }
}

TEST_F(Rayview, BookmarksAreWrittenBesideTheSceneAndNowhereElse) {
  const std::string scene = WriteFile(folder / "in.scn", testing::small_scene);
  const std::string other = WriteFile(folder / "in.scn.views.new", "mine\n");
  const Finished viewed = Follow(scene, "key Control+3\n");
  ASSERT_EQ(viewed.status, 0) << viewed.error;
  EXPECT_EQ(ReadFile(scene + ".views").substr(0, 9), "3 camera ");
  EXPECT_EQ(ReadFile(other), "mine\n");
  EXPECT_EQ(folder.Others({"in.scn", "in.scn.views", "in.scn.views.new", "script.events"}), testing::nothing);
}

// Whether a block needs more samples depends on its neighbors, so that rows cannot be traced one by one.
TEST_F(Rayview, KeySTakesSamplesWhereNeighborsDifferAsRayproDoes) {
  const std::string own = ReadFile(Scene("sphere.scn")) + "\nset samples 16\nset adaptive neighbors\n";
  for (const auto& [scene, more] : {std::pair{WriteFile(folder / "own.scn", own), std::vector<std::string>{}},
                                    {Scene("sphere.scn"), {"-samples", "16", "-adaptive", "neighbors"}}}) {
    const Finished viewed = Follow(scene, "key S\nwait trace\n", testing::With({"-image", folder / "view.png"}, more));
    ASSERT_EQ(viewed.status, 0) << viewed.error;
    const Finished rendered = testing::RunProgram(
        testing::With({scene, folder / "pro.png", "-width", "96", "-height", "64", "-quiet"}, more));
    ASSERT_EQ(rendered.status, 0) << rendered.error;
    EXPECT_TRUE(ImageFrom(folder / "view.png") == ImageFrom(folder / "pro.png")) << scene;
    EXPECT_TRUE(testing::Has(testing::Decode(folder / "view.png").settings["command"], "-adaptive neighbors"));
  }
}

// Regression: a dropped file was read after the names of all outputs had been checked.
TEST_F(Rayview, DroppedFilesAreNeverOverwritten) {
  const std::string texture = folder / "texture.ppm", plain = WriteFile(folder / "plain.scn", testing::small_scene);
  ASSERT_EQ(testing::RunProgram({plain, texture, "-width", "8", "-height", "8"}).status, 0);
  const std::string bytes = ReadFile(texture);
  const std::string textured = WriteFile(
      folder / "textured.scn", "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 texture.ppm\n" + testing::small_scene);
  const std::string drop = "drop " + textured + "\n", drop_reference = "drop " + texture + "\n",
                    trace = "key S\nwait trace\n", image = folder / "image.ppm";
  const struct {
    std::string script;
    std::vector<std::string> words;
  } runs[] = {
      {drop + trace, {"-image", texture}},           {drop + "drop " + plain + "\n" + trace, {"-image", texture}},
      {drop + "tick 1\n", {"-screenshot", texture}}, {drop + "tick 1\n", {"-output_image", texture}},
      {drop_reference + trace, {"-image", texture}}, {drop_reference + "tick 1\n", {"-screenshot", texture}},
      {drop + "tick 1\n", {"-record", textured}}};
  for (const auto& [script, words] : runs) {
    const Finished done = Follow(plain, script, words);
    EXPECT_EQ(done.status, 4) << script << words[0] << done.error;
    EXPECT_TRUE(testing::Has(done.error, "it is the input")) << done.error;
    EXPECT_TRUE(ReadFile(texture) == bytes) << script << words[0];
    EXPECT_TRUE(ReadFile(textured).starts_with("material")) << script << words[0];
  }
}

TEST_F(Rayview, AnAbsentFileIsReportedAsMissing) {
  for (const char* option : {"-events", "-reference"}) {
    const Finished done = Run({Scene("hello.scn"), "-headless", option, folder / "none"});
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(testing::Has(done.error, "none: error: no such file")) << done.error;
  }
}

TEST_F(Rayview, WithoutAnImageNameNothingIsOverwritten) {
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder.Path());
  EXPECT_EQ(Follow(Scene("hello.scn"), "key S\nwait trace\nkey S\nwait trace\nkey F1\n").status, 0);
  std::filesystem::current_path(here);
  EXPECT_TRUE(std::filesystem::file_size(folder / "image1.jpg") > 0);
  EXPECT_TRUE(std::filesystem::file_size(folder / "image2.jpg") > 0);
  const char* const drawing = R2::FormatForName("image.png") ? "image1.png" : "image3.jpg";
  EXPECT_TRUE(std::filesystem::file_size(folder / drawing) > 0);
}

TEST_F(Rayview, EveryContextDrawsTheSameBytes) {
  const std::string script =
      "key B\nkey G\nkey L\nkey E\ndrag left 10 10 40 30\nkey S\nwait trace\nkey Shift+C\n"
      "drag left 10 10 40 30\nkey X\n";
  environment["ASAN_OPTIONS"] = drivers_leak;
  std::vector<std::string> drawn;
  for (const char* context : {"egl", "osmesa"}) {
    const std::string file = folder / (std::string(context) + ".ppm");
    const Finished run = Follow(Scene("hello.scn"), script,
                                {"-context", context, "-screenshot", file, "-image", folder / "x.ppm", "-quiet"});
    if (run.status == 0) drawn.push_back(ReadFile(file));
  }
  if (drawn.size() < 2) GTEST_SKIP() << "this machine has one kind of context only";
  // The last line contains seconds; it is in the lower left corner.
  const R2::Image a = ImageFrom(folder / "egl.ppm"), b = ImageFrom(folder / "osmesa.ppm");
  for (int y = 24; y < a.Height(); ++y)
    for (int x = 0; x < a.Width(); ++x) ASSERT_EQ(a.At(x, y), b.At(x, y)) << x << " " << y;
}

TEST_F(Rayview, EveryContextDrawsTheSamePanels) {
  environment["ASAN_OPTIONS"] = drivers_leak;
  const std::string script = "resize 640 480\nkey Tab\nclick right 200 200\nclick left 200 200\nresize 900 700 1.5\n";
  std::vector<std::string> drawn;
  for (const char* context : {"egl", "osmesa"}) {
    const std::string file = folder / (std::string(context) + ".ppm");
    const Finished run = Follow(Scene("hello.scn"), script, {"-context", context, "-screenshot", file});
    if (run.status == 0) drawn.push_back(ReadFile(file));
  }
  if (drawn.size() < 2) GTEST_SKIP() << "this machine has one kind of context only";
  EXPECT_EQ(drawn[0], drawn[1]);
}

TEST_F(Rayview, ARecordingDoesTheSameAgain) {
  const std::string script =
      "drag left 10 10 50 20\nkey B\ndown right 5 5\npress W\ntick 0.5\nrelease W\nup right 5 5\n"
      "click left 40 30\nscroll 1 30 30\n";
  ASSERT_EQ(
      Follow(Scene("hello.scn"), script, {"-record", folder / "again.events", "-screenshot", folder / "a.ppm"}).status,
      0);
  const Finished again = Run({Scene("hello.scn"), "-headless", "-events", folder / "again.events", "-width", "96",
                              "-height", "64", "-screenshot", folder / "b.ppm"});
  ASSERT_EQ(again.status, 0) << again.error;
  EXPECT_EQ(ReadFile(folder / "a.ppm"), ReadFile(folder / "b.ppm"));
}

// Regression: the time since the last event was not recorded, so that messages that had faded from the window were
// back.
TEST_F(Rayview, ARecordingOfPanelsEndsWithTheSameDrawing) {
  const std::string recorded = folder / "recorded.events";
  const std::string script =
      "resize 600 500\nkey Tab\npanel Scene\npanel Render\npanel light\npanel -max_depth\nkey Control+A\ntype 7\n"
      "key Enter\nclick right 100 250\npanel camera\nkey Tab\nkey Tab\n";
  const Finished first = Follow(Scene("hello.scn"), script, {"-record", recorded, "-screenshot", folder / "first.ppm"});
  ASSERT_EQ(first.status, 0) << first.error;
  const Finished again = Follow(Scene("hello.scn"), ReadFile(recorded), {"-screenshot", folder / "again.ppm"});
  ASSERT_EQ(again.status, 0) << again.error;
  EXPECT_EQ(ReadFile(folder / "again.ppm"), ReadFile(folder / "first.ppm"));
}

TEST_F(Rayview, SettingsOfPanelsAreThoseOfTheSavedImage) {
  const std::string script =
      "resize 600 500\nkey Tab\npanel Scene\npanel Render\npanel light\npanel -max_depth\nkey Control+A\ntype 1\n"
      "key Enter\nkey S\nwait trace\n";
  const Finished viewed = Follow(Scene("hello.scn"), script, {"-image", folder / "view.png"});
  ASSERT_EQ(viewed.status, 0) << viewed.error;
  const Finished rendered = testing::RunProgram(
      {Scene("hello.scn"), folder / "pro.png", "-width", "600", "-height", "500", "-max_depth", "1", "-quiet"});
  ASSERT_EQ(rendered.status, 0) << rendered.error;
  EXPECT_EQ(ImageFrom(folder / "view.png"), ImageFrom(folder / "pro.png"));
}

// In a scene without shadow maps and mirrors, which software takes long to draw.
TEST_F(Rayview, ARecordingEndsWithTheSameDrawing) {
  for (const char* script :
       {"drag left 10 10 50 20\ntick 0.3\n", "key B\ntick 6\n", "scroll 1 30 30\ntick 0.3\n",
        "click right 40 30\ntick 0.1\nkey Left\ntick 4.5\n", "key T\ndrag left 10 10 40 40\ntick 5.5\n",
        "tick 0.1\ndrag left 10 10 40 40\ntick 0.2\ndrag left 20 10 30 40\ntick 5\n"}) {
    const Finished first = Follow(Scene("texture.scn"), script,
                                  {"-record", folder / "again.events", "-screenshot", folder / "a.ppm", "-quiet"});
    ASSERT_EQ(first.status, 0) << first.error;
    const Finished again = Run({Scene("texture.scn"), "-headless", "-events", folder / "again.events", "-width", "96",
                                "-height", "64", "-screenshot", folder / "b.ppm", "-quiet"});
    ASSERT_EQ(again.status, 0) << again.error;
    EXPECT_EQ(ReadFile(folder / "a.ppm"), ReadFile(folder / "b.ppm")) << script;
  }
}

TEST_F(Rayview, ThePrintedRaysAreThoseOfDebugpixel) {
  const Finished viewed = Follow(Scene("glass.scn"), "click right 40 30\n");
  const Finished told =
      testing::RunProgram({Scene("glass.scn"), "-debugpixel", "40", "30", "-width", "96", "-height", "64"});
  ASSERT_EQ(told.status, 0) << told.error;
  EXPECT_EQ(told.output.find("pixel 40 30 of 96 x 64"), 0u) << told.output;
  EXPECT_NE(viewed.output.find(told.output), std::string::npos) << viewed.output;
}

TEST_F(Rayview, ExitImmediatelyDrawsOnce) {
  const Finished run = Run({Scene("hello.scn"), "-headless", "-exit_immediately", "-output_image", folder / "o.png"});
  EXPECT_EQ(run.status, 0) << run.error;
  EXPECT_EQ(ImageFrom(folder / "o.png").Width(), 512);
}

/// Exactly one line that contains each of some words.
void ExpectOneLine(const Finished& run, int status, const std::vector<std::string>& words) {
  EXPECT_EQ(run.status, status) << run.error;
  EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
  for (const std::string& word : words) EXPECT_NE(run.error.find(word), std::string::npos) << run.error;
}

TEST_F(Rayview, MistakesAreReported) {
  environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
#ifdef RAYVIEW_GLFW
  ExpectOneLine(Run({Scene("hello.scn")}), 1, {"rayview: ", "display", "-headless"});
#endif
  ExpectOneLine(Run({Scene("hello.scn"), "-headless", "-image", folder / "a.xyz"}), 2, {".xyz", ".png"});
  ExpectOneLine(Run({Scene("hello.scn"), "-headless", "-image", "/no/such/folder/a.jpg"}), 4, {"/no/such/folder"});
  ExpectOneLine(Run({Scene("hello.scn"), "-headless", "-context", "glx"}), 2, {"glx", "osmesa"});
  EXPECT_EQ(Run({folder / "none.scn", "-headless"}).status, 3);
  const Finished broken = Run({WriteFile(folder / "broken.scn", "spere 1\n"), "-headless"});
  EXPECT_EQ(broken.status, 3);
  EXPECT_NE(broken.error.find("broken.scn:1:1: error: unknown command 'spere'"), std::string::npos) << broken.error;
  const Finished script = Follow(Scene("hello.scn"), "key S\nkee Q\n");
  EXPECT_EQ(script.status, 3);
  EXPECT_NE(script.error.find("script.events:3:1"), std::string::npos) << script.error;
  EXPECT_EQ(Run({Scene("hello.scn"), "-headless", "-events", folder / "none.events"}).status, 3);
  EXPECT_EQ(Run({Scene("hello.scn"), "-headless", "-reference", WriteFile(folder / "x.png", "no image")}).status, 3);
}

// A script that once made an image goes on making it, or says which of its steps the program no longer follows.
TEST_F(Rayview, AStepThatDoesNothingIsAnError) {
  const std::string panels = "resize 600 500\nkey Tab\n";
  const struct {
    std::string script, message;
  } mistakes[] = {
      {"key J\n", "key J has no function"},
      {"key Control+Shift+B\n", "key Control+Shift+B has no function"},
      {"key Tab\ntype 16\n", "no field takes text"},
      {"panel Scene\n", "the panels show no 'Scene'"},
      {panels + "panel no such item\n", "the panels show no 'no such item'"},
      {panels + "panel light theme\n", "the panels show no 'light theme'"},
      {panels + "panel View\npanel dark theme\n", "a click on 'dark theme' changes nothing"},
      {"click left 96.5 10\n", "this is outside of the drawing, which has 96 x 64 pixels"},
      {"scroll 1 10 65\n", "this is outside of the drawing"},
      {"wait rows 4\n", "no image is being rendered"},
      {"wait trace\n", "no image is being rendered"},
      {"key S\nwait rows 65\n", "the render ended after 64 rows"},
      {"drop none.scn\n", "no such file"},
      {"close\nkey B\n", "the viewer was closed before this step"},
  };
  for (const auto& [script, message] : mistakes) {
    const Finished viewed = Follow(Scene("hello.scn"), script, {"-image", folder / "view.ppm", "-quiet"});
    EXPECT_EQ(viewed.status, 1) << script;
    const auto line = 1 + std::ranges::count(script, '\n');  // the first is that of the origin
    EXPECT_TRUE(testing::Has(viewed.error, "script.events:" + std::to_string(line) + ":1: error: " + message))
        << script << viewed.error;
    const std::string good = script.substr(0, script.rfind('\n', script.size() - 2) + 1);
    EXPECT_EQ(Follow(Scene("hello.scn"), good, {"-image", folder / "view.ppm", "-quiet"}).status, 0) << good;
  }
}

TEST_F(Rayview, ARecordingHasOnlyWhatDidSomething) {
  const std::string recorded = folder / "recorded.events";
  EXPECT_EQ(Follow(Scene("hello.scn"), "key J\ntype x\nkey B\n", {"-record", recorded}).status, 1);
  EXPECT_EQ(ReadFile(recorded), "press B\nrelease B\n");
}

/// The window itself, for tests that need more than a script of events.
class RayviewWindow : public Rayview {
 protected:
  void SetUp() override {
#ifndef RAYVIEW_GLFW
    GTEST_SKIP() << "windows are not built in";
#endif
    Rayview::SetUp();
    if (IsSkipped()) return;
    if (!testing::HasServerAndUser()) GTEST_SKIP() << "Xvfb or xdotool is not installed";
    server.emplace();
    if (server->Display().empty()) GTEST_SKIP() << "Xvfb does not start here";
    display.emplace("DISPLAY", server->Display().c_str());
    environment["DISPLAY"] = server->Display();
    environment["ASAN_OPTIONS"] = drivers_leak;
    environment["XDG_CONFIG_HOME"] = folder / "config";
  }
  /// Makes xdotool act on the window; tries until the window exists.
  static bool Do(const std::string& actions) {
    const std::string line = "timeout 20 xdotool search --onlyvisible --name '^rayview hello.scn' windowfocus " +
                             actions + " >/dev/null 2>&1";
    for (int i = 0; i < 100; ++i) {
      if (std::system(line.c_str()) == 0) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  static void WaitForFile(const std::string& file) {
    for (int i = 0; i < 200 && !(std::filesystem::exists(file) && std::filesystem::file_size(file) > 0); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }

  std::optional<testing::Server> server;
  std::optional<testing::Variable> display;
};

TEST_F(RayviewWindow, KeepsTheLayoutOfPanelsOnceItIsChanged) {
  const std::string habits = folder / "config/raypro/rayview";
  // The edge of the panels, in units from the left.
  constexpr int window = 400, edge = window - 196, dragged_to = 150;
  // Interrupted, since xdotool may fail if its key closes the window.
  const auto look_at = [&](const std::string& actions) {
    testing::Running view({Scene("hello.scn"), "-width", "400", "-height", "200", "-panels", "light", "-quiet"},
                          {.program = "RAYVIEW", .environment = environment});
    EXPECT_TRUE(Do(actions)) << "there is no window";
    view.Send(SIGINT);
    const Finished seen = view.Wait();
    EXPECT_EQ(seen.status, 128 + SIGINT) << seen.error;
  };
  const auto pointer = [](int x, const std::string& pause) {
    return "mousemove --window %1 " + std::to_string(x) + " 100 sleep " + pause + " ";
  };
  look_at(pointer(edge + 1, "0.3"));
  EXPECT_FALSE(std::filesystem::exists(habits)) << "nobody has changed anything";
  // A busy machine takes longer to draw the change.
  for (const std::string pause : {"0.3", "1", "3"}) {
    look_at(pointer(edge + 1, pause) + "mousedown 1 sleep " + pause + " " + pointer(dragged_to + 1, pause) +
            "mouseup 1 sleep " + pause);
    if (std::filesystem::exists(habits)) break;
  }
  EXPECT_EQ(ReadFile(habits), "theme light\nletters 1\nwidth " + std::to_string(window - dragged_to) + "\n");
}

TEST_F(RayviewWindow, IgnoresBrokenPreferencesWithAMessage) {
  std::filesystem::create_directories(folder / "config/raypro");
  const std::string habits = WriteFile(folder / "config/raypro/rayview", "theme pink\n");
  const Finished viewed = Run({Scene("hello.scn"), "-exit_immediately"});
  EXPECT_EQ(viewed.status, 0);
  EXPECT_NE(viewed.error.find(habits + " cannot be parsed"), std::string::npos) << viewed.error;
  EXPECT_EQ(ReadFile(habits), "theme pink\n");
}

TEST_F(RayviewWindow, GetsInputAndShowsTheDrawnPixels) {
  if (std::system("command -v import >/dev/null 2>&1") != 0) GTEST_SKIP() << "needs import, of ImageMagick";
  testing::Running view({Scene("hello.scn"), "-width", "160", "-height", "120", "-image", folder / "traced.ppm",
                         "-output_image", folder / "end.png", "-record", folder / "what.events", "-quiet"},
                        {.program = "RAYVIEW", .environment = environment});
  ASSERT_TRUE(Do("key s")) << "there is no window";
  WaitForFile(folder / "traced.ppm");
  Do("mousemove --window %1 40 40 mousedown 1 mousemove --window %1 60 50 mousemove --window %1 80 60 mouseup 1");
  Do("mousemove --window %1 80 60 click 4");
  Do("windowsize --sync %1 200 150");
  Do("key b key g");
  std::this_thread::sleep_for(std::chrono::milliseconds(7000));  // until the message has faded
  const std::string shot =
      "xdotool search --onlyvisible --name hello.scn | head -1 | xargs -I{} import -window {} " + (folder / "shot.png");
  EXPECT_EQ(std::system(shot.c_str()), 0);
  Do("key q");
  const Finished end = view.Wait(std::chrono::seconds(20));
  ASSERT_EQ(end.status, 0) << end.error;

  const Finished rendered =
      testing::RunProgram({Scene("hello.scn"), folder / "pro.ppm", "-width", "160", "-height", "120", "-quiet"});
  ASSERT_EQ(rendered.status, 0);
  EXPECT_EQ(ReadFile(folder / "traced.ppm"), ReadFile(folder / "pro.ppm"));
  const R2::Image read = ImageFrom(folder / "end.png"), seen = ImageFrom(folder / "shot.png");
  ASSERT_EQ(read.Width(), 200);
  ASSERT_EQ(read.Height(), 150);
  EXPECT_EQ(read, seen);
  const std::string events = ReadFile(folder / "what.events");
  for (const char* step : {"press S", "down left", "up left", "scroll 1", "resize 200 150", "press G", "press Q"})
    EXPECT_NE(events.find(step), std::string::npos) << step << "\n" << events;
}

TEST_F(RayviewWindow, DrawsTheBytesOfOtherContexts) {
  const std::string script = WriteFile(folder / "s.events", "key B\nkey G\ndrag left 10 10 40 30\nkey L\n");
  const std::vector<std::string> common{Scene("hello.scn"), "-width", "160", "-height", "120", "-events", script};
  std::vector<std::string> window = common, none = common;
  window.insert(window.end(), {"-screenshot", folder / "w.ppm"});
  none.insert(none.end(), {"-headless", "-screenshot", folder / "n.ppm"});
  ASSERT_EQ(Run(window).status, 0);
  ASSERT_EQ(Run(none).status, 0);
  EXPECT_EQ(ReadFile(folder / "w.ppm"), ReadFile(folder / "n.ppm"));
}

}  // namespace
}  // namespace ray

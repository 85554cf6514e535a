#include "source/app/rayview/SaveImage.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <sstream>

#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/RayproCommand.h"
#include "source/app/options/SceneSettings.h"
#include "source/scene/CameraText.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Decode;
using testing::ReadFile;
using testing::RunProgram;
using testing::TemporaryFolder;
using testing::WriteFile;
using Words = std::vector<std::string>;

const std::string small_scene =
    "camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\nmaterial .2 .1 0  .8 .5 .3  .5 .5 .5  0 0 0  0 0 0  20 1  0\n"
    "sphere 0  0 0 0  1\nbox 0  -1 -2 -1  1 -1.5 1\n";

/// Changes the current folder for its lifetime.
class Inside {
 public:
  explicit Inside(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
  ~Inside() { std::filesystem::current_path(before_); }
  Inside(const Inside&) = delete;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

ViewerOptions ViewOf(const std::string& scene, const Words& more) {
  Words words{scene, "-width", "24", "-height", "16"};
  words.insert(words.end(), more.begin(), more.end());
  return ReadCommandLine<ViewerOptions>(Program::rayview, words);
}

/// Traces and saves like rayview's key S; returns the settings in the image.
R2::ImageSettings TraceAndSave(const ViewerOptions& options, const std::string& name) {
  const LoadedScene scene(options.files.scene, options.parse, options.accelerator);
  const ImageOutput output = CheckImageOutput(name, {});
  SaveTraced(&output, options, scene, Render(scene.world, *scene.accelerator, options.render), 1.5);
  return Decode(name).settings;
}

/// Returns the words of a line without quotes.
Words Split(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(RayproCommand, MakesTheSameImage) {
  ViewerOptions options = ReadCommandLine<ViewerOptions>(Program::rayview, Words{"room.scn", "-image", "a.png"});
  EXPECT_EQ(RayproCommand(options), "raypro room.scn a.png -width 512 -height 512");
  options = ReadCommandLine<ViewerOptions>(
      Program::rayview,
      Words{"my room.scn", "-image",   "a.png",       "-width", "256",         "-height", "300",
            "-samples",    "16",       "-motion",     "0",      "-1",          ".5",      "-srgb",
            "-shadows",    "off",      "-allow_path", "x",      "-allow_path", "y",       "-env=-sky.hdr",
            "-verbose",    "-headless"});
  EXPECT_EQ(
      RayproCommand(options),
      "raypro 'my room.scn' a.png -width 256 -height 300 -samples 16 -motion 0 -1 0.5 -srgb -env=-sky.hdr -shadows off "
      "-allow_path=x -allow_path=y");
  options = ReadCommandLine<ViewerOptions>(Program::rayview, Words{"-image=-a.png", "--", "-room.scn"});
  EXPECT_EQ(RayproCommand(options), "raypro ./-room.scn ./-a.png -width 512 -height 512");
}

// The scene may set another value than the default that was typed.
TEST(RayproCommand, KeepsOnlyTypedOptionsThatAffectTheImage) {
  const auto options =
      ReadCommandLine(Program::raypro, Words{"--samples=1", "in.scn", "-threads", "2", "out.png", "-verbose", "-resume",
                                             "-checkpoint", "1m", "-report", "r.json", "-seed", "3", "-srgb"});
  EXPECT_EQ(RayproCommand(options), "raypro in.scn out.png -samples 1 -seed 3 -srgb");
}

// An image saved by S must equal raypro's image.
TEST(SaveImage, EveryFormatIsRayprosFileByteForByte) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const Inside inside(folder.Path());
  WriteFile("in.scn", small_scene);
  for (const Words& more : {Words{}, {"-samples", "4", "-filter", "mitchell"}, {"-mode", "path", "-srgb"}})
    for (const R2::ImageFormat& format : R2::ImageFormats()) {
      const std::string name = "out." + std::string(format.extensions[0]);
      ViewerOptions options = ViewOf("in.scn", more);
      TraceAndSave(options, name);
      const std::string viewed = ReadFile(name);
      options.files.image = name;
      Words words = Split(RayproCommand(options));
      words.erase(words.begin());
      ASSERT_EQ(RunProgram(words).status, 0);
      EXPECT_TRUE(!viewed.empty() && viewed == ReadFile(name)) << name;
    }
}

TEST(SaveImage, IsRayprosFileIfTheSceneHasSettingsToo) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const Inside inside(folder.Path());
  WriteFile("in.scn", small_scene + "set max_depth 2\nset samples 4\n");
  const LoadedScene scene("in.scn", {}, {});
  TraceAndSave(WithSettingsOf(scene.parsed.scene, ViewOf("in.scn", {"-samples", "1"})), "out.png");
  const std::string viewed = ReadFile("out.png");
  ASSERT_EQ(RunProgram({"in.scn", "out.png", "-samples", "1", "-height", "16", "-width", "24"}).status, 0);
  EXPECT_TRUE(!viewed.empty() && viewed == ReadFile("out.png"));
}

TEST(SaveImage, TheImageHasTheSettingsOfRayprosImage) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const Inside inside(folder.Path());
  WriteFile("in.scn", small_scene);
  auto ours = TraceAndSave(ViewOf("in.scn", {"-seed", "7"}), "out.png");
  EXPECT_EQ(ours["command"], "raypro in.scn out.png -width 24 -height 16 -seed 7");
  ASSERT_EQ(RunProgram({"in.scn", "out.png", "-width", "24", "-height", "16", "-seed", "7"}).status, 0);
  EXPECT_EQ(ours, Decode("out.png").settings);
  EXPECT_EQ(TraceAndSave(ViewOf("in.scn", {"-keep_times"}), "out.png")["seconds"], "1.500");
}

TEST(SaveImage, RecordsTheCameraIfItIsNotTheScenes) {
  const TemporaryFolder folder;
  const Inside inside(folder.Path());
  WriteFile("in.scn", small_scene);
  ViewerOptions options = ViewOf("in.scn", {});
  options.render.view = LoadedScene("in.scn", {}, {}).parsed.scene.camera;
  EXPECT_FALSE(TraceAndSave(options, "out.png").contains("camera"));
  options.render.view->eye.x = 0.1;
  options.render.view->xfov = 1. / 3;
  EXPECT_EQ(TraceAndSave(options, "out.png")["camera"], "camera 0.1 0 6  0 0 -1  0 1 0  0.3333333333333333  0.1 100");
}

TEST(SaveImage, ACameraLineParsesBackToTheCamera) {
  Camera camera = Aim({1, 2e-300, -3.1}, {1, 2, 3}, {0.3, 1, 0}).camera;
  camera.xfov = 0.7;
  camera.near = 1e-5;
  const Camera read = project::FromText(CameraLine(camera) + "\n").camera;
  EXPECT_EQ(read.eye.y, camera.eye.y);
  EXPECT_EQ(read.xfov, camera.xfov);
  EXPECT_EQ(read.near, camera.near);
  EXPECT_NEAR(Dot(read.towards, camera.towards), 1, 1e-15);
}

TEST(SaveImage, WithoutANameItTakesTheFirstUnusedOne) {
  const TemporaryFolder folder;
  const Inside inside(folder.Path());
  WriteFile("in.scn", small_scene);
  WriteFile("image1.jpg", "mine");
  std::filesystem::create_symlink("nowhere", "image3.jpg");
  const ViewerOptions options = ViewOf("in.scn", {});
  const LoadedScene scene(options.files.scene, options.parse, options.accelerator);
  const RenderResult result = Render(scene.world, *scene.accelerator, options.render);
  EXPECT_TRUE(SaveTraced(nullptr, options, scene, result, 1).starts_with("image2.jpg 24x16 1 spp 1.00 s "));
  EXPECT_TRUE(SaveTraced(nullptr, options, scene, result, 1).starts_with("image4.jpg "));
  EXPECT_EQ(ReadFile("image1.jpg"), "mine");
  EXPECT_FALSE(std::filesystem::exists("nowhere"));
  EXPECT_GT(ReadFile("image2.jpg").size(), 100u);
}

TEST(SaveImage, ANameOfAFailedSaveIsUnusedAgain) {
  const TemporaryFolder folder;
  const Inside inside(folder.Path());
  WriteFile("in.scn", "");
  const ViewerOptions options = ViewOf("in.scn", {});
  const LoadedScene scene(options.files.scene, options.parse, options.accelerator);
  RenderResult result;
  result.image = R2::Image(70'000, 1);  // larger than a JPEG can be
  result.pixels_done = result.pixels_total = 70'000;
  EXPECT_THROW(SaveTraced(nullptr, options, scene, result, 1), R2::ImageError);
  EXPECT_EQ(folder.Others({"in.scn"}), Words{});
}

TEST(SaveImage, ADrawingKeepsTheDisplayedValues) {
  const TemporaryFolder folder;
  R2::Image drawing(2, 1);
  drawing.Set(0, 0, {128 / 255., 1, 0});
  for (const char* name : {"a.png", "a.ppm", "a.bmp"}) {
    SaveDrawing(CheckImageOutput(folder / name, {}), drawing, ViewOf("in.scn", {"-srgb"}).encoding);
    const auto read = Decode(folder / name);
    EXPECT_NEAR(read.image.At(0, 0).r, 128 / 255., 1e-6) << name;
    const auto program = read.settings.find("program");
    EXPECT_TRUE(program == read.settings.end() || program->second.starts_with("rayview ")) << name;
  }
}

TEST(ViewOutputs, AreCheckedBeforeAnyWork) {
  const TemporaryFolder folder;
  const std::string scene = WriteFile(folder / "in.scn", "");
  const auto check = [&](const Words& more) {
    const ViewerOptions options = ViewOf(scene, more);
    return CheckViewOutputs(options.files, options.view, options.render.width, options.render.height);
  };
  const ViewOutputs none = check({});
  EXPECT_FALSE(none.image || none.output_image || none.screenshot || none.record);
  const ViewOutputs all = check({"-image", folder / "a.png", "-output_image", folder / "b.jpg", "-screenshot",
                                 folder / "c.hdr", "-record", folder / "events"});
  EXPECT_EQ(all.image->file.name, folder / "a.png");
  EXPECT_STREQ(all.output_image->format->name, "jpeg");
  EXPECT_TRUE(all.screenshot && all.record);
  EXPECT_EQ(folder.Others({"in.scn"}), Words{});

  EXPECT_THROW(check({"-image", folder / "a.xyz"}), UsageError);
  EXPECT_THROW(check({"-image", folder / "a.png", "-output_image", folder / "a.png"}), UsageError);
  EXPECT_THROW(check({"-screenshot", folder / "a.png", "-record", folder / "a.png"}), UsageError);
  EXPECT_THROW(check({"-record", folder / "missing/events"}), OutputError);
  EXPECT_THROW(check({"-events", scene, "-record", scene}), OutputError);
  WriteFile(folder / "ref.png", "");
  EXPECT_THROW(check({"-reference", folder / "ref.png", "-image", folder / "ref.png"}), OutputError);
  EXPECT_THROW(RefuseInputs(check({"-image", folder / "ref.png"}), Words{folder / "ref.png"}), OutputError);
}

}  // namespace
}  // namespace ray

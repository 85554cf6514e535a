// Sessions of the real viewer by scripts, without a window: scenes are changed and saved, images denoised.

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Finished;
using testing::ReadFile;
using testing::TemporaryFolder;
using testing::WriteFile;

class RayviewScripts : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::ProgramName("RAYVIEW")) GTEST_SKIP() << "rayview is not built here: nothing to draw with";
    std::filesystem::copy(project::Root() / "scenes/textures", folder.Path() / "textures");
    std::filesystem::copy(project::Root() / "scenes/meshes", folder.Path() / "meshes");
    before = ReadFile(project::Root() / "scenes/hello.scn");
    WriteFile(scene, before);
    const Finished trial = testing::RunProgram({scene, "-headless"}, {.program = "RAYVIEW"});
    if (trial.status == 1) GTEST_SKIP() << "this machine cannot draw: " << trial.error;
  }
  Finished Follow(const std::string& script, const std::vector<std::string>& more = {}) const {
    return testing::RunProgram(
        testing::With({scene, "-headless", "-events", WriteFile(folder / "script.events", "origin bottom\n" + script), "-image",
                       folder / "view.png", "-quiet"},
                      more),
        {.program = "RAYVIEW"});
  }
  std::vector<std::string> ChangedLines() const {
    std::istringstream was(before), is(ReadFile(scene));
    std::vector<std::string> changed;
    for (std::string old, now; std::getline(was, old);)
      if (std::getline(is, now) && now != old) changed.push_back(now);
    return changed;
  }

  /// Renders pro.png as a window of that size does. Returns the exit status.
  int RenderLikeTheWindow() const {
    const std::vector<std::string> words{scene,  folder / "pro.png", "-width", "96", "-height", "64", "-samples", "16",
                                         "-quiet"};
    return testing::RunProgram(words).status;
  }

  TemporaryFolder folder;
  const std::string scene = folder / "hello.scn";
  std::string before;
};

TEST_F(RayviewScripts, TheRedConeTurnsGreenAndMovesAndIsSaved) {
  const Finished viewed = Follow(
      "resize 900 2000\nkey Tab\npanel cone, line 18\npanel Material\n"
      "panel diffuse (kd)\ntype 0.1 0.6 0.15\nkey Enter\npanel pick diffuse\n"
      "key =\nkey Control+Z\nkey Control+Y\nkey Control+S\n"
      "key Tab\nresize 96 64\nkey S\nwait trace\nprint\n");
  ASSERT_EQ(viewed.status, 0) << viewed.error;
  EXPECT_NE(viewed.output.find("edits 2 changes, saved"), std::string::npos) << viewed.output;
  const std::vector<std::string> changed = ChangedLines();
  ASSERT_EQ(changed.size(), 2u);
  EXPECT_NE(changed[0].find("0.1 0.6 0.15"), std::string::npos) << changed[0];
  EXPECT_TRUE(changed[0].ends_with("# 3 red")) << changed[0];
  EXPECT_EQ(changed[1], "cone      3    2.5 0.9 -1.1   0.75 1.8");
  ASSERT_EQ(RenderLikeTheWindow(), 0);
  EXPECT_EQ(testing::Decode(folder / "view.png").image, testing::Decode(folder / "pro.png").image);
}

// The hash of an image identifies the text of its scene, whether it is saved or not.
TEST_F(RayviewScripts, AnImageBeforeSavingHasTheHashOfItsText) {
  const auto hash_after = [&](const std::string& script) {
    EXPECT_EQ(Follow(script + "resize 32 24\nkey S\nwait trace\n").status, 0);
    return testing::Decode(folder / "view.png").settings.at("scene_hash");
  };
  const std::string unchanged = hash_after("");
  const std::string edited = hash_after("resize 900 2000\nkey Tab\npanel cone, line 18\nkey =\n");
  EXPECT_NE(edited, unchanged);
  EXPECT_EQ(ReadFile(scene), before) << "nothing was saved";
  EXPECT_EQ(hash_after("resize 900 2000\nkey Tab\npanel cone, line 18\nkey =\nkey Control+S\n"), edited);
  EXPECT_EQ(hash_after(""), edited);
}

// A render that was stopped after an hour is kept when the viewer is closed.
TEST_F(RayviewScripts, AStoppedImageIsContinuedByRaypro) {
  const std::vector<std::string> options{"-samples", "16", "-seed", "3"}, size{"-width", "96", "-height", "64"};
  const std::string checkpoint = folder / "view.png.checkpoint";
  const std::string script = "resize 96 64\nkey S\nwait rows 16\nkey Escape\nwait trace\n";
  const Finished viewed = Follow(script + "print\n", options);
  ASSERT_EQ(viewed.status, 0) << viewed.error;
  ASSERT_TRUE(std::filesystem::exists(checkpoint)) << viewed.output;
  EXPECT_NE(viewed.output.find("raypro -resume also continues, from " + checkpoint), std::string::npos)
      << viewed.output;
  const auto raypro = [&](const std::string& out, const std::vector<std::string>& more) {
    return testing::RunProgram(
        testing::With(testing::With({scene, folder / out, "-quiet"}, testing::With(options, size)), more));
  };
  const Finished resumed = raypro("view.png", {"-resume"});
  ASSERT_EQ(resumed.status, 0) << resumed.error;
  EXPECT_FALSE(std::filesystem::exists(checkpoint));
  ASSERT_EQ(raypro("fresh.png", {}).status, 0);
  EXPECT_EQ(testing::Decode(folder / "view.png").image, testing::Decode(folder / "fresh.png").image);

  // Once the viewer itself continues the render, no checkpoint remains.
  std::filesystem::remove(folder / "view.png");
  ASSERT_EQ(Follow(script + "key S\nwait trace\n", options).status, 0);
  EXPECT_FALSE(std::filesystem::exists(checkpoint));
  EXPECT_EQ(testing::Decode(folder / "view.png").image, testing::Decode(folder / "fresh.png").image);

  // Another render must not replace a checkpoint either, which may contain hours of work.
  std::filesystem::remove(folder / "view.png");
  WriteFile(checkpoint, "somebody's");
  ASSERT_EQ(Follow(script, options).status, 0);
  EXPECT_EQ(ReadFile(checkpoint), "somebody's");
}

TEST_F(RayviewScripts, FocusOnAPointIsWrittenToTheScene) {
  ASSERT_EQ(Follow("resize 96 64\nmove 48 30\nkey K\nkey Control+S\nkey S\nwait trace\n").status, 0);
  const std::string after = ReadFile(scene);
  EXPECT_NE(after.find("\nset focus "), std::string::npos) << after;
  EXPECT_NE(after.find("\nset aperture "), std::string::npos);
  ASSERT_EQ(RenderLikeTheWindow(), 0);
  EXPECT_EQ(testing::Decode(folder / "view.png").image, testing::Decode(folder / "pro.png").image);
}

TEST_F(RayviewScripts, KeyMDenoisesTheImageAsRayproDoes) {
  const std::vector<std::string> options{"-width", "48", "-height", "32", "-samples", "4", "-mode", "path"};
  ASSERT_EQ(Follow("key M\nkey S\nwait trace\n", options).status, 0);
  ASSERT_EQ(testing::RunProgram(testing::With({scene, folder / "pro.png", "-denoise", "-quiet"}, options)).status, 0);
  EXPECT_EQ(testing::Decode(folder / "view.png").image, testing::Decode(folder / "pro.png").image);
  ASSERT_EQ(testing::RunProgram(testing::With({scene, folder / "pro.png", "-quiet"}, options)).status, 0);
  EXPECT_NE(testing::Decode(folder / "view.png").image, testing::Decode(folder / "pro.png").image);
}

}  // namespace
}  // namespace ray

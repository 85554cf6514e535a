// Scripts for users: their documented behavior, and that they report a program that fails.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Has;
using testing::ReadFile;
using testing::SceneFolder;
using testing::TemporaryFolder;
using testing::WriteFile;

struct Ended {
  int status;
  std::string said;
};

/// Runs a script of script/ in its own folder; `words` is written as in the shell.
Ended RunScript(const TemporaryFolder& place, const std::string& script, const std::string& words,
                const std::string& environment = {}) {
  const std::string command = "cd '" + place.Path().string() + "' && " + environment + " '" +
                              (std::filesystem::canonical(project::Root()) / "script" / script).string() + "' " +
                              words + " > said 2>&1";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), ReadFile(place / "said")};
}

const std::string small_frames = " -width 32 -height 24 -frames 2 -keep";

/// Returns the frames of a movie that was kept, from the folder that its script prints.
std::filesystem::path FramesOf(const TemporaryFolder& place, const Ended& ended) {
  const std::string before = "the frames are in ";
  const std::size_t at = ended.said.find(before);
  if (at == std::string::npos) return {};
  const std::size_t start = at + before.size();
  return place.Path() / ended.said.substr(start, ended.said.find('\n', start) - start);
}

constexpr const char* rolled = "camera 1 2 6  -.1 -.3 -1  1 1 0  0.4  0.1 100\nview 2 .5 0\nbox -1  -1 -1 -1  1 1 1\n";

TEST(MovieScript, AnOptionThatChangesLeavesTheCameraAsItIs) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place(rolled);
  const Ended ended = RunScript(place, "movie.sh", "-sweep seed 1 1 in.scn out.avi" + small_frames);
  ASSERT_EQ(ended.status, 0) << ended.said;
  ASSERT_EQ(
      testing::RunProgram({place.Scene(), place / "one.jpg", "-width", "32", "-height", "24", "-seed", "1", "-quiet"})
          .status,
      0);
  EXPECT_EQ(testing::Decode(FramesOf(place, ended) / "frame00001.jpg").image, testing::Decode(place / "one.jpg").image);
}

// Including a camera that is rolled, and a scene a ten-thousandth of a unit wide.
TEST(MovieScript, TheFirstOrbitFrameIsTheScenesOwnView) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  for (const char* scene :
       {rolled,
        "camera 0 .0001 .0004  0 -.2 -1  0 1 0  0.3  .0001 1\nbox -1  -.0001 -.0001 -.0001  .0001 .0001 .0001\n"}) {
    const SceneFolder place(scene);
    const Ended ended = RunScript(place, "movie.sh", "-turntable in.scn out.avi" + small_frames);
    ASSERT_EQ(ended.status, 0) << ended.said;
    ASSERT_EQ(testing::RunProgram({place.Scene(), place / "one.jpg", "-width", "32", "-height", "24", "-quiet"}).status,
              0);
    const auto frames = FramesOf(place, ended);
    const R2::Image own = testing::Decode(place / "one.jpg").image;
    EXPECT_EQ(testing::Decode(frames / "frame00000.jpg").image, own);
    EXPECT_TRUE(Has(ReadFile(frames / "frame00001.scn"), "camera ")) << "half an orbit later";
  }
}

TEST(MovieScript, ScenesOfAllLanguagesAreTaken) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const TemporaryFolder place;
  WriteFile(place / "in.yaml", R"(Eye: [200, 200, 1000]
Lights: [{position: [-200, 600, 1500], color: [1, 1, 1]}]
Objects: [{type: sphere, position: [200, 200, 0], radius: 90,
           material: {color: [0, 0, 1], ka: 0.2, kd: 0.7, ks: 0.5, n: 64}}]
)");
  const Ended ended = RunScript(place, "movie.sh", "-turntable in.yaml out.avi -width 16 -height 12 -frames 2");
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_TRUE(std::filesystem::exists(place / "out.avi"));
}

TEST(MovieScript, AVariableGoesFromOneValueToAnother) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place("define t 0\ncamera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\nsphere -1  $t 0 0  1\n");
  const Ended ended = RunScript(place, "movie.sh", "-define t -1 0.5 in.scn out.avi" + small_frames);
  ASSERT_EQ(ended.status, 0) << ended.said;
  const auto frames = FramesOf(place, ended);
  for (const auto& [frame, value] : {std::pair("frame00000.jpg", "t=-1"), std::pair("frame00001.jpg", "t=0.5")}) {
    ASSERT_EQ(testing::RunProgram(
                  {place.Scene(), place / "one.jpg", "-width", "32", "-height", "24", "-quiet", "-define", value})
                  .status,
              0);
    EXPECT_EQ(testing::Decode(frames / frame).image, testing::Decode(place / "one.jpg").image) << value;
  }
}

TEST(MovieScript, ATourGoesThroughTheBookmarksOfTheViewer) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place(rolled);
  const std::array<std::string, 3> cameras{"camera 0 2 6  0 -.3 -1  0 1 0  0.4  0.1 100",
                                           "camera 6 2 1  -1 -.3 0  0 1 0  0.5  0.1 100",
                                           "camera 0 3 -6  0 -.4 1  0 1 0  0.3  0.1 100"};
  WriteFile(place.Scene() + ".views", "5 " + cameras[2] + "\n1 " + cameras[0] + "\n2 " + cameras[1] + "\n");
  const Ended ended =
      RunScript(place, "movie.sh", "-bookmarks in.scn out.avi -width 32 -height 24 -frames 5 -keep");
  ASSERT_EQ(ended.status, 0) << ended.said;
  const auto frames = FramesOf(place, ended);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const std::string scene = WriteFile(place / "own.scn", std::string(rolled) + cameras[i] + "\n");
    ASSERT_EQ(testing::RunProgram({scene, place / "one.jpg", "-width", "32", "-height", "24", "-quiet"}).status, 0);
    EXPECT_EQ(testing::Decode(frames / ("frame0000" + std::to_string(2 * i) + ".jpg")).image,
              testing::Decode(place / "one.jpg").image);
  }
  WriteFile(place.Scene() + ".views", "1 " + cameras[0] + "\n");
  const Ended refused = RunScript(place, "movie.sh", "-bookmarks in.scn out.avi");
  EXPECT_EQ(refused.status, 3);
  EXPECT_TRUE(Has(refused.said, "-bookmarks needs two of them")) << refused.said;
}

TEST(MovieScript, UnwritableFilesAreRefusedBeforeTheFirstFrame) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const Ended ended = RunScript(place, "movie.sh", "-turntable in.scn out.mov");
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(Has(ended.said, "a movie is .avi, .webp or .mp4, got 'out.mov'")) << ended.said;
}

TEST(ParallelScript, NamesAreNeverPatterns) {
  NEEDS_THE_PROGRAM();
  if (std::system("command -v parallel > /dev/null") != 0) GTEST_SKIP() << "there is no GNU parallel here";
  for (const std::string name : {"shot[1].png", "s{}h{1}{.}.png", "a\\nb\\\\.png", "a *b?.png"}) {
    const TemporaryFolder place;
    WriteFile(place / "in {} [1].scn", testing::small_scene);
    const Ended ended =
        RunScript(place, "farm/parallel.sh", "-parts 3 'in {} [1].scn' '" + name + "' -width 16 -height 12 -samples 2");
    EXPECT_EQ(ended.status, 0) << name << ended.said;
    EXPECT_EQ(place.Others({"in {} [1].scn", "said", name}), testing::nothing);
    EXPECT_EQ(testing::Decode(place / name).image.Width(), 16) << name;
  }
}

/// Runs movie.sh with a raypro that records each frame that it renders in the file "rendered", and refuses the frame
/// that the file "refuse" names.
Ended CountedMovie(const TemporaryFolder& place, const std::string& words) {
  const std::string raypro = WriteFile(place / "raypro.sh", R"x(#!/bin/sh
case "$*" in *-check* | *-convert*) exec "$REAL" "$@" ;; esac
echo frame >> rendered
[ ! -f refuse ] || case "$*" in *"$(cat refuse)"*) exit 1 ;; esac
exec "$REAL" "$@"
)x");
  std::filesystem::permissions(raypro, std::filesystem::perms::owner_all);
  return RunScript(place, "movie.sh", words + " -width 16 -height 12", "REAL=\"$RAYPRO\" RAYPRO=./raypro.sh");
}

constexpr const char* moving = "define t 0\ncamera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\nsphere -1  $t 0 0  1\n";

TEST(MovieScript, MistakesAreReportedBeforeTheFirstFrame) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const struct {
    std::string words;
    int status;
    std::string said;
  } refusals[] = {
      {"-define t 0,5 1 in.scn out.avi", 2, "-define t must be a number such as -1 or 0.5, got '0,5'"},
      {"-define t 0 one in.scn out.avi", 2, "got 'one'"},
      {"-define t 0 1/2 in.scn out.avi", 2, "got '1/2'"},
      {"-define t 0 1e999 in.scn out.avi", 2, "got '1e999'"},
      {"-define t 0 '1\n' in.scn out.avi", 2, "got '1"},
      {"-define t 0 nan in.scn out.avi", 2, "got 'nan'"},
      {"-sweep aperture 0 '' in.scn out.avi", 2, "-sweep aperture must be a number"},
      {"-sweep aperture 0 0x1 in.scn out.avi", 2, "got '0x1'"},
      {"-sweep samples 1 4 -frames 3 in.scn out.avi", 2, "-samples"},  // 2.5
      {"-sweep samples 4 -1 in.scn out.avi", 2, "-samples"},
      {"-turntable -turns 1,5 in.scn out.avi", 2, "-turns must be a number"},
      {"-turntable -fps 24,5 in.scn out.avi", 2, "-fps must be a number"},
      {"-turntable -fps 0 in.scn out.avi", 2, "-fps must be 0.1 to 1000"},
      {"-turntable -fps -5 in.scn out.avi", 2, "-fps must be 0.1 to 1000"},
      {"-turntable -frames 2.5 in.scn out.avi", 2, "-frames must be a whole number"},
      {"-turntable -frames 08 in.scn out.avi", 2, "-frames must be a whole number"},
      {"-to '0 0 5 0 0 -1 0 1 0 0,4' in.scn out.avi", 2, "-to must be a number"},
      {"-to '0 0 5 0 0 -1 0 1 0' in.scn out.avi", 2, "-to needs ten numbers"},
      {"-to '0 0 5 0 0 0 0 1 0 .4' in.scn out.avi", 3, "frame00047.scn:2"},  // no direction at the end
      {"-turntable in.scn nowhere/out.avi", 4, "the folder 'nowhere' does not exist"},
      {"-turntable in.scn folder.avi", 4, "it is a folder"},
      {"-turntable in.scn out.avi -samples 0", 2, "-samples"},
      {"-turntable in.scn out.avi -sample 4", 2, "unknown option '-sample'"},
      {"-define t 1 -1 wrong.scn out.avi", 3, "radius must not be negative, got -1"},  // at the end only
  };
  for (const auto& [words, status, said] : refusals) {
    const SceneFolder place(moving);
    WriteFile(place / "wrong.scn", "define t 0\nsphere -1 0 0 0 $t\n");
    std::filesystem::create_directory(place / "folder.avi");
    const Ended ended = CountedMovie(place, words);
    EXPECT_EQ(ended.status, status) << words << ended.said;
    EXPECT_TRUE(Has(ended.said, said)) << words << ended.said;
    EXPECT_EQ(place.Others({"in.scn", "wrong.scn", "folder.avi", "raypro.sh", "said"}), testing::nothing) << words;
  }
}

TEST(MovieScript, ItsOwnCamerasAreNoReasonForWarnings) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place(moving);
  for (const char* way : {"-turntable", "-to '0 0 5 0 0 -1 0 1 0 .4'"}) {
    const Ended ended = CountedMovie(place, std::string(way) + " -define t 0 1e-1 -frames 3 in.scn out.avi");
    EXPECT_EQ(ended.status, 0) << ended.said;
    EXPECT_EQ(ended.said, "");
  }
}

TEST(MovieScript, FramesOutliveLaterFailures) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const std::string words = "-define t 0 1 -frames 3 in.scn out.avi";
  const SceneFolder place(moving);
  WriteFile(place / "refuse", "frame00002.scn");
  const Ended among = CountedMovie(place, words);
  EXPECT_NE(among.status, 0);
  EXPECT_TRUE(std::filesystem::exists(FramesOf(place, among) / "frame00001.jpg")) << among.said;
  WriteFile(place / "rayimg.sh", "exit 4\n");
  std::filesystem::permissions(place / "rayimg.sh", std::filesystem::perms::owner_all);
  const Ended last = RunScript(place, "movie.sh", words + " -width 16 -height 12", "RAYIMG=./rayimg.sh");
  EXPECT_EQ(last.status, 4);
  EXPECT_TRUE(std::filesystem::exists(FramesOf(place, last) / "frame00002.jpg")) << last.said;
}

TEST(MovieScript, NamesAreNeverPatterns) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const TemporaryFolder place;
  const std::string folder = R"(a [1] {b}\n 'c')", name = R"(x "y" \t$z#.scn)";
  std::filesystem::create_directory(place / folder);
  WriteFile(place / folder + "/" + name, moving);
  WriteFile(place / "name", folder + "/" + name);
  const Ended ended = RunScript(
      place, "movie.sh", "-define t 0 1 -turntable -frames 2 -width 16 -height 12 \"$(cat name)\" 'o[1] %d.avi'");
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_TRUE(std::filesystem::exists(place / "o[1] %d.avi")) << ended.said;
}

TEST(MovieScript, ProgramsBesideItAreFoundOffThePath) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place(moving);
  const auto script = std::filesystem::canonical(project::Root()) / "script" / "movie.sh";
  std::filesystem::create_directory(place / "bin");
  std::filesystem::copy(script, place / "bin/raypro-movie");
  for (const char* variable : {"RAYPRO", "RAYIMG"})
    std::filesystem::create_symlink(std::filesystem::canonical(testing::ProgramName(variable)),
                                    place / (std::string("bin/") + (variable[3] == 'P' ? "raypro" : "rayimg")));
  std::filesystem::create_symlink("bin/raypro-movie", place / "linked");
  for (const char* command : {"sh bin/raypro-movie", "./linked"}) {
    const std::string all = "cd '" + place.Path().string() + "' && env -u RAYPRO -u RAYIMG PATH=/usr/bin:/bin " +
                            command + " -define t 0 1 -frames 2 -width 16 -height 12 in.scn out.avi > said 2>&1";
    EXPECT_EQ(std::system(all.c_str()), 0) << command << ReadFile(place / "said");
    EXPECT_TRUE(std::filesystem::remove(place / "out.avi")) << command;
  }
}

TEST(PreviewDifferenceScript, AProgramThatFailsIsAFailure) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place;
  const Ended ended = RunScript(place, "preview_difference.sh", "-size 16 in.scn", "RAYVIEW=/bin/false");
  EXPECT_NE(ended.status, 0) << ended.said;
  EXPECT_TRUE(Has(ended.said, "/bin/false failed")) << ended.said;
  EXPECT_FALSE(Has(ended.said, "mean of")) << ended.said;
}

}  // namespace
}  // namespace ray

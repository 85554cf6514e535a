// Runs of raypro -convert.
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

const std::string small_scene_text = "point_light 1 1 1  0 3 5  1 0 0\nsphere -1  0 0 0  1\n";

TEST(Convert, WritesTheSceneAndReportsIt) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", small_scene_text);
  const Finished done = RunProgram({"-convert", place / "out.scn", scene});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.output, "wrote '" + place / "out.scn" + "'\n");
  EXPECT_EQ(done.error, "");
  EXPECT_TRUE(Has(ReadFile(place / "out.scn"), "sphere -1 0 0 0 1\n"));
  EXPECT_EQ(RunProgram({scene, "-convert=" + place / "out.scn", "-quiet"}).output, "");
  EXPECT_EQ(place.Others({"in.scn", "out.scn"}), std::vector<std::string>{});
}

TEST(Convert, RefusesToReplaceAFileOfTheSceneItself) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  WriteFile(place / "part.scn", small_scene_text);
  const std::string scene = WriteFile(place / "in.scn", "include part.scn\n");
  fs::create_symlink("in.scn", place / "link.scn");
  for (const char* name : {"in.scn", "part.scn", "link.scn"}) {
    const Finished done = RunProgram({"-convert", place / name, scene});
    EXPECT_NE(done.status, 0) << name;
    EXPECT_TRUE(Has(done.error, "it is the input")) << done.error;
  }
  EXPECT_EQ(ReadFile(scene), "include part.scn\n");
  EXPECT_EQ(ReadFile(place / "part.scn"), small_scene_text);
}

TEST(Convert, NonsenseIsRefusedWithTheReason) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", small_scene_text), out = place / "out.scn";
  const struct {
    std::vector<std::string> words;
    const char* reason;
  } cases[] = {
      {{"-convert"}, "-convert needs a value"},
      {{"-convert", out}, "no scene is named"},
      {{"-convert", place / "out.yaml", scene}, "scenes are written as .scn"},
      {{"-convert", place / "out", scene}, "scenes are written as .scn"},
      {{"-convert", place / "no/out.scn", scene}, "does not exist"},
      {{"-convert", out, place / "absent.scn"}, "no such file"},
      {{"-convert", out, scene, "picture.png"}, "-convert writes no image"},
      {{"-convert", out, scene, "-check"}, "cannot be combined"},
      {{"-convert", out, scene, "-width", "20"}, "-width has no effect with -convert"},
  };
  for (const auto& [words, reason] : cases) {
    const Finished done = RunProgram(words);
    EXPECT_NE(done.status, 0) << reason;
    EXPECT_TRUE(Has(done.error, reason)) << done.error;
  }
  EXPECT_EQ(place.Others({"in.scn"}), std::vector<std::string>{});
}

TEST(Convert, AWrongSettingIsReportedAndNothingWritten) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", "set max_depth much\n" + small_scene_text);
  const Finished done = RunProgram({"-convert", place / "out.scn", scene});
  EXPECT_EQ(done.status, 3);
  EXPECT_TRUE(Has(done.error, "in.scn:1:5")) << done.error;
  EXPECT_EQ(place.Others({"in.scn"}), std::vector<std::string>{});
}

TEST(Convert, AMeshReplacesNoExistingFile) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  // A polygon with enough corners to be written as a mesh.
  std::string text = "polygon -1 100";
  for (int i = 0; i < 100; ++i) text += " " + std::to_string(i) + " " + std::to_string(i * i) + " 0";
  const std::string scene = WriteFile(place / "in.scn", text + "\n");
  const Finished first = RunProgram({"-convert", place / "out.scn", scene});
  EXPECT_EQ(first.status, 0) << first.error;
  const auto meshes = place.Others({"in.scn", "out.scn"});
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(RunProgram({"-convert", place / "out.scn", scene}).status, 0) << "the same file again";
  WriteFile(place / meshes[0], "mine\n");
  const Finished done = RunProgram({"-convert", place / "out.scn", scene});
  EXPECT_EQ(done.status, 4);
  EXPECT_TRUE(Has(done.error, "already exists with different content")) << done.error;
  EXPECT_EQ(ReadFile(place / meshes[0]), "mine\n");
}

TEST(Convert, AnUnwritableFolderIsReported) {
  NEEDS_THE_PROGRAM();
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may write anywhere";
  const TemporaryFolder place;
  const std::string scene = WriteFile(place / "in.scn", small_scene_text), folder = place / "locked";
  fs::create_directory(folder);
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  const Finished done = RunProgram({"-convert", folder + "/out.scn", scene});
  fs::permissions(folder, fs::perms::owner_all);
  EXPECT_NE(done.status, 0);
  EXPECT_TRUE(Has(done.error, "Permission denied")) << done.error;
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(Convert, NamesTheFolderThatItsReaderMustAllow) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  fs::create_directories(place / "scenes");
  fs::create_directories(place / "copies");
  WriteFile(place / "scenes/one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string scene = WriteFile(place / "scenes/in.scn", "mesh -1 one.off\n"), out = place / "copies/out.scn";
  const Finished done = RunProgram({"-convert", out, scene});
  EXPECT_EQ(done.status, 0);
  const std::string allowed = fs::canonical(place / "scenes").string();
  EXPECT_TRUE(Has(done.error, "-allow_path " + allowed)) << done.error;
  EXPECT_NE(RunProgram({out, place / "a.ppm", "-width", "4"}).status, 0);
  EXPECT_EQ(RunProgram({out, place / "a.ppm", "-width", "4", "-allow_path", allowed}).status, 0);
}

}  // namespace
}  // namespace ray::testing

#include "source/text/SimilarFile.h"

#include <gtest/gtest.h>

#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

std::string Similar(const Folder& folder, const std::string& name, const std::string& unlike = ".scn") {
  return SimilarFile(folder.Path(), name, unlike, [](const std::filesystem::path&) { return true; });
}

TEST(SimilarFile, LetterCaseSlashesAndSlipsLeadToTheFile) {
  const Folder folder;
  for (const char* file : {"cube.off", "sub/part.obj", "Textures/Wood Floor.png", "bunny.ply"}) folder.Write(file, "");
  EXPECT_EQ(Similar(folder, "CUBE.OFF"), "cube.off");
  EXPECT_EQ(Similar(folder, "cueb.off"), "cube.off");
  EXPECT_EQ(Similar(folder, "sub\\part.obj"), "sub/part.obj");
  EXPECT_EQ(Similar(folder, "SUB/prat.obj"), "sub/part.obj");
  EXPECT_EQ(Similar(folder, "textures/wood floor.PNG"), "Textures/Wood Floor.png");
  EXPECT_EQ(Similar(folder, "./sub/../cub.off"), "./sub/../cube.off");
  EXPECT_EQ(Similar(folder, "bunny"), "bunny.ply");
  EXPECT_EQ(Similar(folder, "bunny.obj"), "bunny.ply");
  EXPECT_EQ(Similar(folder, (folder / "CUBE.off").string()), (folder / "cube.off").string());
}

TEST(SimilarFile, ThePathOfAnotherMachineLeadsToAFileHere) {
  const Folder folder;
  folder.Write("wood.png", "");
  EXPECT_EQ(Similar(folder, "C:\\Users\\me\\Textures\\wood.png"), "wood.png");
  EXPECT_EQ(Similar(folder, "/home/me/textures/Wood.png"), "wood.png");
}

TEST(SimilarFile, WhatIsNotSimilarIsNotProposed) {
  const Folder folder;
  folder.Write("scene.scn", "");
  folder.Write("a.off", "");
  EXPECT_EQ(Similar(folder, "scene.png"), "") << "a scene is no texture";
  EXPECT_EQ(Similar(folder, "scene"), "");
  EXPECT_EQ(Similar(folder, "scene", ""), "scene.scn");
  EXPECT_EQ(Similar(folder, "b.off"), "") << "the extension alone makes them no kin";
  EXPECT_EQ(Similar(folder, "a"), "a.off");
  EXPECT_EQ(Similar(folder, ""), "");
  EXPECT_EQ(Similar(folder, "none/at/all"), "");
}

TEST(SimilarFile, AFolderThatMayNotBeReadIsNotListed) {
  const Folder folder;
  folder.Write("open/a.off", "");
  folder.Write("shut/cube.off", "");
  const auto may_list = [&](const std::filesystem::path& path) { return path.filename() != "shut"; };
  EXPECT_EQ(SimilarFile(folder.Path(), "shut/CUBE.OFF", "", may_list), "");
  EXPECT_EQ(SimilarFile(folder.Path(), "OPEN/a.off", "", may_list), "open/a.off");
}

TEST(SimilarFile, TheHintStandsAtTheNameInTheScene) {
  const Folder folder;
  folder.Write("cube.off", "OFF 0 0 0");
  folder.Write("textures/wood.png", "");
  folder.Write("scene.scn",
               "mesh -1 CUBE.OFF\nmaterial 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 textures\\wood.png\ninclude scen.scn\n");
  const std::string report = ReportOf(folder, "scene.scn");
  EXPECT_TRUE(Contains(report,
                       "scene.scn:1:9: error: no such file: 'CUBE.OFF'\n    1 | mesh -1 CUBE.OFF\n"
                       "      |         ^~~~~~~~ did you mean 'cube.off'?"))
      << report;
  EXPECT_TRUE(Contains(report, "did you mean 'textures/wood.png'?"));
  EXPECT_TRUE(Contains(report, "did you mean 'scene.scn'?"));
  EXPECT_EQ(ReportOf(folder, "scenes.scn"), "scenes.scn: error: no such file; did you mean 'scene.scn'?");
}

// A scene may come from a stranger: it learns nothing of folders that it may not read.
TEST(SimilarFile, AScenesHintsLookOnlyWhereItMayRead) {
  const Folder outside, folder;
  outside.Write("secret.off", "");
  folder.Write("scene.scn", "mesh -1 " + (outside / "SECRET.off").string() + "\n");
  EXPECT_FALSE(Contains(ReportOf(folder, "scene.scn"), "did you mean"));
}

}  // namespace
}  // namespace ray

// Completion scripts are run in bash itself, in a folder with files of every kind.
#include "source/app/manual/Manual.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "tests/source/app/Program.h"

namespace ray {
namespace {

class Completion : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v bash >/dev/null 2>&1") != 0) GTEST_SKIP() << "bash is not installed";
    for (const char* name : {"a.scn", "b.OBJ", "c.png", "D.JPG", "e.json", "f.mp3", "two words.scn"})
      ray::testing::WriteFile(folder_ / name, "");
    std::filesystem::create_directory(folder_ / "sub");
  }

  /// Returns the completions that bash offers for the last word, in alphabetical order and separated by strokes.
  std::string Offers(const Program& program, const std::string& words) const {
    const std::string script = folder_ / "complete.mp3";
    ray::testing::WriteFile(script, BashCompletion(program));
    const std::string command = "cd \"" + folder_ / "." +
                                "\" && bash -c '. ./complete.mp3; rm complete.mp3; COMP_WORDS=(" + words +
                                "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _" + NameOf(program) +
                                "; printf \"%s\\n\" \"${COMPREPLY[@]}\"' | LC_ALL=C sort | paste -s -d \"|\" -";
    FILE* pipe = popen(command.c_str(), "r");
    char line[4096] = "";
    if (pipe && !std::fgets(line, sizeof line, pipe)) line[0] = 0;
    if (pipe) pclose(pipe);
    std::string offers = line;
    if (offers.ends_with('\n')) offers.pop_back();
    return offers;
  }
  std::string Raypro(const std::string& words) const { return Offers(Program::raypro, "raypro " + words); }
  std::string Rayview(const std::string& words) const { return Offers(Program::rayview, "rayview " + words); }
  std::string Rayimg(const std::string& words) const { return Offers(Program::rayimg, "rayimg " + words); }

 private:
  const ray::testing::TemporaryFolder folder_;
};

TEST_F(Completion, BashFindsOptionsAndTheirChoices) {
  EXPECT_EQ(Raypro("-wid"), "-width");
  EXPECT_EQ(Raypro("in.scn out.jpg -shadows o"), "off|on");
  EXPECT_EQ(Raypro("-complete b"), "bash");
  EXPECT_EQ(Rayview("in.scn -headl"), "-headless");
  EXPECT_EQ(Rayview("in.scn -context o"), "osmesa");
}

TEST_F(Completion, BashFindsChoicesAfterAnEqualSign) {
  EXPECT_EQ(Raypro("-shadows ="), "off|on");
  EXPECT_EQ(Raypro("-shadows = of"), "off");
}

TEST_F(Completion, BashFindsNamesAmongOtherValuesAndInLists) {
  EXPECT_EQ(Raypro("-lights a"), "all|auto");
  EXPECT_EQ(Raypro("-layers n"), "normal");
  EXPECT_EQ(Raypro("-layers depth,n"), "depth,normal");
}

TEST_F(Completion, BashOffersNothingForNumbers) {
  EXPECT_EQ(Raypro("-width \"\""), "");
  EXPECT_EQ(Raypro("-crop \"\""), "");
}

TEST_F(Completion, BashOffersScenesThenImages) {
  EXPECT_EQ(Raypro("\"\""), "a.scn|b.OBJ|e.json|sub|two words.scn");
  EXPECT_EQ(Raypro("tw"), "two words.scn");
  EXPECT_EQ(Raypro("a.scn \"\""), "D.JPG|c.png|sub");
  EXPECT_EQ(Rayview("\"\""), "a.scn|b.OBJ|e.json|sub|two words.scn");
  EXPECT_EQ(Rayimg("info \"\""), "D.JPG|c.png|sub");
}

TEST_F(Completion, BashOffersMoreScenesWhereThereMayBeSeveral) {
  EXPECT_EQ(Raypro("-out_folder sub a.scn \"\""), "a.scn|b.OBJ|e.json|sub|two words.scn");
}

TEST_F(Completion, BashOffersTheFilesAnOptionTakes) {
  EXPECT_EQ(Raypro("a.scn -env \"\""), "D.JPG|c.png|sub");
  EXPECT_EQ(Raypro("a.scn -reference \"\""), "D.JPG|c.png|sub");
  EXPECT_EQ(Raypro("-info \"\""), "D.JPG|c.png|sub");
  EXPECT_EQ(Raypro("a.scn -report \"\""), "e.json|sub");
  EXPECT_EQ(Raypro("a.scn -convert \"\""), "a.scn|sub|two words.scn");
  EXPECT_EQ(Rayview("a.scn -screenshot \"\""), "D.JPG|c.png|sub");
  EXPECT_EQ(Rayview("a.scn -events f"), "f.mp3");
  EXPECT_EQ(Rayimg("diff c.png D.JPG -map \"\""), "D.JPG|c.png|sub");
}

TEST_F(Completion, BashOffersFoldersForFolders) {
  EXPECT_EQ(Raypro("-out_folder \"\""), "sub");
  EXPECT_EQ(Raypro("-allow_path \"\""), "sub");
}

}  // namespace
}  // namespace ray

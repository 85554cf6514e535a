// Right ray tracers of others, in grader/tests/students: what raygrade calls a mistake in their images is one of ours.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "grader/raygrade/LoadScene.h"
#include "grader/Grader.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

/// Their sources, where a sandbox's user may read them.
struct StudentsFolder : TemporaryFolder {
  StudentsFolder() {
    fs::copy(project::Root() / "grader/tests/students", Path());
    fs::permissions(Path(), fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
  }
};

bool Succeeds(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }

/// All scenes of a suite but those that the program does not claim to know, graded with what `command` says.
void ExpectAllPoints(const std::string& course, const std::vector<std::string>& command, const fs::path& readable,
                     const std::string& unknown = {}) {
  grade::Suite suite = grade::ReadSuite((project::Root() / "share/suites" / course / "suite.yaml").string());
  suite.readable.push_back(readable.string());
  suite.memory = 16384;  // Node reserves far more than it uses
  std::erase_if(suite.scenes, [&](const grade::SuiteScene& scene) { return scene.name == unknown; });
  for (const grade::SuiteScene& scene : suite.scenes) {
    grade::Suite alone = suite;
    alone.scenes = {scene};
    grade::GraderSettings settings{.command = command, .image_extension = "ppm"};
    if (Has(scene.options, "-fresnel")) settings.command.push_back("fresnel");
    grade::Grader grader(alone, settings, raygrade::LoadScene);
    const grade::StudentResult result = grader.Grade("student", "", [](const grade::StudentResult&) {});
    EXPECT_EQ(result.Score(), result.Points()) << scene.file << ": " << result.scenes[0].headline << "\n"
                                               << result.scenes[0].program_output;
  }
}

TEST(Students, ARightProgramInCMakesNoMistakes) {
  if (!Succeeds("cc --version")) GTEST_SKIP() << "there is no C compiler";
  const StudentsFolder place;
  const std::string program = place / "scn";
  ASSERT_TRUE(Succeeds("cc -std=c99 -O2 '" + place / "scn.c" + "' -lm -o '" + program + "'"));
  const std::vector<std::string> command{program, "{scene}", "{image}", "{width}", "{height}"};
  ExpectAllPoints("cos426", command, place.Path(), "smooth");
  ExpectAllPoints("infogr", command, place.Path());
}

TEST(Students, ARightProgramInPythonMakesNoMistakes) {
  if (!Succeeds("python3 --version")) GTEST_SKIP() << "there is no python3";
  const StudentsFolder place;
  ExpectAllPoints("groningen", {"python3", place / "groningen.py", "{scene}", "{image}", "{width}", "{height}"},
                  place.Path());
}

TEST(Students, ARightProgramInJavaScriptMakesNoMistakes) {
  if (!Succeeds("node --version")) GTEST_SKIP() << "there is no Node";
  const StudentsFolder place;
  ExpectAllPoints("cs315", {"node", place / "cs315.mjs", "{scene}", "{image}", "{width}", "{height}"}, place.Path());
}

}  // namespace
}  // namespace ray::testing

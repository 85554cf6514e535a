// The program raygrade, as a teacher calls it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

#define NEEDS_RAYGRADE()                                                                                           \
  NEEDS_THE_PROGRAM();                                                                                             \
  NEEDS_NO_SANITIZER("raypro needs more memory than graded programs may have");                                    \
  if (!ray::testing::ProgramName("RAYGRADE")) GTEST_SKIP() << "the environment variable RAYGRADE does not name it"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

/// A teacher's folder: a suite of one scene, and students' folders with the files that build a program.
struct TeachersFolder : TemporaryFolder {
  TeachersFolder() {
    fs::permissions(Path(), fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
    WriteFile(*this / "a.scn", small_scene);
    WriteFile(*this / "suite.yaml", "width: 32\nheight: 24\nscenes:\n  - scene: a.scn\n");
  }

  /// A copy of raypro, since a sandbox shows no other folder, and a program that is called as the suite does.
  void AddTracer(const std::string& folder, const std::string& name = "tracer") const {
    fs::create_directories(Path() / folder);
    fs::copy_file(ProgramName(), Path() / folder / "raypro");
    fs::permissions(WriteFile(*this / (folder + "/" + name), "#!/bin/sh\nexec \"$(dirname \"$0\")/raypro\" \"$@\"\n"),
                    fs::perms::all);
  }
  /// Runs raygrade in this folder and returns its output on both streams.
  std::string Graded(const std::string& words, int expected_status = 0) const {
    const std::string printed = *this / "printed";
    const int status =
        std::system(("cd '" + Path().string() + "' && '" + fs::absolute(ProgramName("RAYGRADE")).string() +
                     "' suite.yaml " + words + " > '" + printed + "' 2>&1")
                        .c_str());
    const std::string text = ReadFile(printed);
    EXPECT_EQ(WEXITSTATUS(status), expected_status) << words << "\n" << text;
    return text;
  }
};

constexpr const char* size = " -width {width} -height {height}";

TEST(Raygrade, AProgramOfTheCurrentFolderIsFoundInTheSandbox) {
  NEEDS_RAYGRADE();
  const TeachersFolder place;
  place.AddTracer(".", "student");
  EXPECT_TRUE(Has(place.Graded(std::string("-- ./student {scene} {image}") + size), "a: 1/1"));
  EXPECT_TRUE(Has(place.Graded(std::string("-- /bin/sh student {scene} {image}") + size), "a: 1/1"));
}

TEST(Raygrade, AProgramBehindALinkIsFoundInTheSandbox) {
  NEEDS_RAYGRADE();
  const TeachersFolder place;
  place.AddTracer("real");
  fs::create_directory_symlink("real", place / "linked");
  EXPECT_TRUE(Has(place.Graded(std::string("-- linked/tracer {scene} {image}") + size), "a: 1/1"));
}

TEST(Raygrade, AMissingProgramIsReportedBeforeAnyPoints) {
  NEEDS_RAYGRADE();
  const TeachersFolder place;
  WriteFile(place / "plain", "text");
  fs::create_directories(place / "handed_in/amy");
  for (const auto& [words, reason] : {std::pair{"-- ./student {scene} {image}", "there is no program './student'"},
                                      {"-- student {scene}", "there is no program 'student' in /usr/local/bin"},
                                      {"-- plain {scene}", "write ./plain"},
                                      {"-- ./plain {scene}", "not executable"},
                                      {"-- sh tracer.sh {scene}", "there is no file 'tracer.sh' for sh"},
                                      {"-students handed_in -- {student}/tracer {scene}", "-build"}}) {
    const std::string printed = place.Graded(words, 2);
    EXPECT_TRUE(Has(printed, reason)) << printed;
    EXPECT_FALSE(Has(printed, "a: 0/1")) << printed;
  }
}

TEST(Raygrade, StudentsWithoutAProgramAreNamedFirst) {
  NEEDS_RAYGRADE();
  const TeachersFolder place;
  place.AddTracer("handed_in/amy");
  fs::create_directories(place / "handed_in/bob");
  const std::string printed =
      place.Graded(std::string("-students handed_in -- {student}/tracer {scene} {image}") + size);
  EXPECT_LT(printed.find("there is no 'tracer' in the folders of bob"), printed.find("amy: a: 1/1")) << printed;
  EXPECT_TRUE(Has(ReadFile(place / "graded/bob/index.html"), "there is no tracer in the folder"));
}

TEST(Raygrade, ProgramsAreBuiltInCopiesAndTheirLogIsOnThePage) {
  NEEDS_RAYGRADE();
  if (std::system("make --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no make";
  const TeachersFolder place;
  place.AddTracer("handed_in/amy", "tracer.in");
  WriteFile(place / "handed_in/amy/Makefile", "tracer: tracer.in\n\t@echo building it\n\tcp tracer.in tracer\n");
  place.AddTracer("handed_in/bob", "tracer.in");
  WriteFile(place / "handed_in/bob/Makefile", "tracer: tracer.on\n\tcp tracer.in tracer\n");
  place.AddTracer("handed_in/cat", "tracer.in");
  WriteFile(place / "handed_in/cat/Makefile", "all:\n\t:\n");
  const std::string printed = place.Graded(
      std::string("-students handed_in -build 'make -C {student}' -- {student}/tracer {scene} {image}") + size);
  EXPECT_TRUE(Has(printed, "amy: a: 1/1")) << printed;
  EXPECT_TRUE(Has(printed, "bob: The program was not built: the command make -C {student} ended")) << printed;
  EXPECT_TRUE(Has(printed, "cat: The program was not built: the command make -C {student} did not make tracer"))
      << printed;
  EXPECT_TRUE(Has(ReadFile(place / "graded/amy/index.html"), "building it"));
  EXPECT_TRUE(Has(ReadFile(place / "graded/bob/index.html"), "tracer.on"));
  EXPECT_FALSE(fs::exists(place / "handed_in/amy/tracer")) << "the submission has changed";
}

TEST(Raygrade, CommentsOfTeachersOutliveResume) {
  NEEDS_RAYGRADE();
  const TeachersFolder place;
  place.AddTracer("handed_in/amy");
  const std::string words = std::string("-students handed_in -resume -- {student}/tracer {scene} {image}") + size;
  place.Graded(words);
  for (const char* comment : {"Well done & neat", ""}) {
    WriteFile(place / "graded/amy/comment.txt", std::string(comment) + "\n");
    EXPECT_FALSE(Has(place.Graded(words), "amy: a:")) << "graded again";
    const bool has_comment = *comment != 0;
    EXPECT_EQ(Has(ReadFile(place / "graded/amy/index.html"), "Well done &amp; neat"), has_comment);
    EXPECT_EQ(Has(ReadFile(place / "graded/index.html"), "Well done &amp; neat"), has_comment);
    EXPECT_EQ(Has(ReadFile(place / "graded/class.csv"), "Well done & neat"), has_comment);
  }
}

TEST(Raygrade, OptionsWithoutEffectAreAnError) {
  NEEDS_RAYGRADE();
  const TeachersFolder place;
  WriteFile(place / "suite.yaml",
            "width: 32\nheight: 24\nscenes:\n  - scene: a.scn\n    options: \"-fov 40 -fresnel\"\n");
  const std::string printed = place.Graded("-- /bin/true {scene}", 3);
  EXPECT_TRUE(Has(printed, "suite.yaml:5:14: error: the option '-fresnel' does not change the image of a")) << printed;
}

TEST(Raygrade, TheBuildCommandHasItsOwnLimits) {
  NEEDS_RAYGRADE();
  const TeachersFolder place;
  WriteFile(place / "suite.yaml", "width: 32\nheight: 24\nbuild_seconds: 0.5\nscenes:\n  - scene: a.scn\n");
  place.AddTracer("handed_in/amy");
  const std::string printed =
      place.Graded("-students handed_in -build 'sleep 60' -- {student}/tracer {scene} {image}");
  EXPECT_TRUE(Has(printed, "was not built: the command sleep 60 was stopped after 0.5")) << printed;
}

/// Returns the commands of docs/teachers.md in lines that begin so and contain a text, in one line.
std::string CommandsOfTheDocs(const std::string& begin, const std::string& text) {
  std::istringstream page(ReadFile((project::Root() / "docs/teachers.md").string()));
  std::string commands;
  for (std::string line; std::getline(page, line);)
    if (line.starts_with(begin) && Has(line, text))
      commands += (commands.empty() ? "" : " && ") + line.substr(begin.size());
  return commands;
}

/// Runs commands of the docs in a folder, with raygrade in PATH.
void ExpectSuccess(const TeachersFolder& place, const std::string& commands) {
  fs::create_directory(place / "bin");
  fs::create_symlink(fs::absolute(ProgramName("RAYGRADE")), place / "bin/raygrade");
  const std::string call = "cd '" + place.Path().string() + "' && PATH='" + place / "bin" + "':$PATH; (" + commands +
                           ") > '" + place / "printed" + "' 2>&1";
  EXPECT_EQ(std::system(call.c_str()), 0) << call << "\n" << ReadFile(place / "printed");
}

TEST(Raygrade, TheRecipeForGradescopeLeavesItsResults) {
  NEEDS_RAYGRADE();
  if (std::system("make --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no make";
  const TeachersFolder place;
  place.AddTracer("submission", "tracer.in");
  WriteFile(place / "submission/Makefile", "tracer: tracer.in\n\tcp tracer.in tracer\n");
  for (const char* folder : {"source", "results"}) fs::create_directory(place / folder);
  for (const char* file : {"a.scn", "suite.yaml"}) fs::rename(place / file, place.Path() / "source" / file);
  std::string commands = CommandsOfTheDocs("    ", "/autograder/");
  ASSERT_TRUE(Has(commands, "raygrade ")) << commands;
  for (const auto& [what, with] : {std::pair{std::string("/autograder"), place.Path().string()},
                                   {std::string("/tmp/graded"), place / "graded"}})
    for (std::size_t at = commands.find(what); at != commands.npos; at = commands.find(what, at + with.size()))
      commands.replace(at, what.size(), with);
  ExpectSuccess(place, commands);
  EXPECT_TRUE(Has(ReadFile(place / "results/results.json"), "\"max_score\"")) << ReadFile(place / "printed");
}

TEST(Raygrade, TheRecipeForGithubLeavesItsPages) {
  NEEDS_RAYGRADE();
  if (std::system("make --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no make";
  const TeachersFolder place;
  place.AddTracer(".", "tracer.in");
  WriteFile(place / "Makefile", "tracer: tracer.in\n\tcp tracer.in tracer\n");
  fs::create_directory(place / "suite");
  for (const char* file : {"a.scn", "suite.yaml"}) fs::rename(place / file, place.Path() / "suite" / file);
  const std::string commands = CommandsOfTheDocs("      - run: ", "");
  ASSERT_TRUE(Has(commands, "make && raygrade ")) << commands;
  ExpectSuccess(place, commands);
  // The step after these uploads this folder.
  ASSERT_TRUE(Has(CommandsOfTheDocs("        with: ", ""), "path: graded}"));
  EXPECT_TRUE(Has(ReadFile(place / "graded/index.html"), "<html")) << ReadFile(place / "printed");
}

TEST(Raygrade, TenMinutesAreEnoughForAClassOfFour) {
  NEEDS_RAYGRADE();
  if (std::system("cc --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no C compiler";
  const fs::path script = fs::absolute(project::Root() / "grader/tests/class_of_four.sh");
  EXPECT_EQ(std::system(("sh '" + script.string() + "' > /dev/null").c_str()), 0) << script;
}

}  // namespace
}  // namespace ray::testing

// What README.md and docs/ show: their commands run, and what they show as output is what is printed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/Project.h"

namespace {

TEST(Docs, EveryCommandShownRunsAndPrintsWhatIsShown) {
  for (const char* program : {"RAYPRO", "RAYIMG", "RAYGRADE"})
    if (!std::getenv(program)) GTEST_SKIP() << program << " is not set";
  if (std::system("python3 -c 'import sys; sys.exit(sys.version_info < (3, 9))' > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "python3, of 3.9 or later, is not installed";
  const std::filesystem::path root = std::filesystem::absolute(project::Root());
  const std::string command =
      "PYTHONDONTWRITEBYTECODE=1 python3 '" + (root / "tests/docs/commands.py").string() + "' '" + root.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

// Each of these is a way in which a page could go out of date.
TEST(Docs, ACommandThatFailsOrAnswersOtherwiseIsFound) {
  for (const char* program : {"RAYPRO", "RAYIMG", "RAYGRADE"})
    if (!std::getenv(program)) GTEST_SKIP() << program << " is not set";
  const std::filesystem::path root = std::filesystem::absolute(project::Root());
  const std::string run =
      "PYTHONDONTWRITEBYTECODE=1 python3 '" + (root / "tests/docs/commands.py").string() + "' '" + root.string() + "' ";
  if (std::system("python3 -c pass > /dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is not installed";
  const std::filesystem::path page = std::filesystem::temp_directory_path() / "raytests-page.md";
  for (const char* shown : {"    raypro in.scn out.png -sample 4", "Try `raypro nowhere.scn out.png`.",
                            "    rayimg info nothing.png", "    script/movie.sh -turnabout in.scn out.avi",
                            "    scenes/room.scn:14:1: error: unknown command 'spere'\n"
                            "       14 | spere 0  0 1 0  0.5\n          | ^~~~~ did you mean 'spear'?\n"
                            "    included from scenes/main.scn:3"}) {
    std::ofstream(page) << shown << "\n";
    EXPECT_NE(std::system((run + page.string() + " > /dev/null 2>&1").c_str()), 0) << shown;
  }
  std::ofstream(page) << "    raypro in.scn out.png -samples 4\n";
  EXPECT_EQ(std::system((run + page.string()).c_str()), 0);
  std::filesystem::remove(page);
}

}  // namespace

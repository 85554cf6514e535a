// A page of commands and code that nobody runs is soon wrong.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/Project.h"

namespace {

namespace fs = std::filesystem;

TEST(Contributing, EveryScriptRunsAndEveryListedCommandExists) {
  if (!std::getenv("RAYPRO") || !std::getenv("RAYIMG")) GTEST_SKIP() << "RAYPRO or RAYIMG is not set";
  const std::string command = "'" + (project::Root() / "tests/scripts.sh").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

TEST(Contributing, ItsExampleShapeRenders) {
  const char* const program = std::getenv("RAYPRO");
  const fs::path root = project::Root();
  const fs::path build = program ? fs::path(program).parent_path().lexically_relative(root) : fs::path();
  if (build.empty() || build.native().starts_with("..")) GTEST_SKIP() << "the build is not below the sources";
  const std::string command = "'" + (root / "tests/contributing.sh").string() + "' '" + build.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace

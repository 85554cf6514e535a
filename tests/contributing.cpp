// A page of commands and code that nobody runs is soon wrong.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/Project.h"

namespace {

TEST(Contributing, ItsShapeCompilesIsFoundEverywhereAndSeenAndItsCommandsExist) {
  const char* const program = std::getenv("RAYPRO");
  const std::filesystem::path root = project::Root();
  const std::filesystem::path build =
      program ? std::filesystem::path(program).parent_path().lexically_relative(root) : std::filesystem::path();
  if (build.empty() || build.native().starts_with("..")) GTEST_SKIP() << "the build is not below the sources";
  const std::string command = "'" + (root / "tests/contributing.sh").string() + "' '" + build.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace

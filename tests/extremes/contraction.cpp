// What decides whether rays leak between triangles must not depend on how the program was built.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>

#include "tests/Project.h"

namespace {

/// What a command prints, and how it ends.
std::pair<std::string, int> Execute(const std::string& command) {
  std::string text;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return {"", -1};
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  const int status = pclose(pipe);
  return {text, WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

TEST(Extremes, D4_ABuildThatFusesProductsAndSumsIsRefused) {
  if (Execute("make --version").second != 0) GTEST_SKIP() << "there is no make here";
  const std::string make = "env -u MAKEFLAGS -u MAKELEVEL make -n -C " + project::Root().string() + " raypro ";
  for (const char* flags : {"CXXFLAGS=-ffp-contract=fast", "CXXFLAGS='-g -ffast-math'", "OPTIMIZE=-Ofast"}) {
    const auto [text, status] = Execute(make + flags);
    EXPECT_NE(status, 0) << flags;
    EXPECT_NE(text.find("changes how numbers are rounded"), std::string::npos) << flags << '\n' << text;
  }
}

}  // namespace

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/Project.h"

namespace ray {
namespace {

std::set<std::string> AllThatMatch(const std::string& text, const std::regex& pattern) {
  std::set<std::string> all;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    all.insert((*match)[1]);
  return all;
}

// A missing one is looked up through GLX or EGL, which ends the program if neither has a context.
TEST(OsMesa, HasEveryFunctionOfOpenGlThatWeCall) {
  const std::filesystem::path draw = project::Root() / "source/draw";
  std::set<std::string> called;
  for (const auto& file : std::filesystem::directory_iterator(draw / "gl"))
    called.merge(AllThatMatch(project::BytesOf(file.path()), std::regex("\\bgl([A-Z][A-Za-z0-9]+)\\b")));
  EXPECT_GT(called.size(), 60U);
  const auto has = AllThatMatch(project::BytesOf(draw / "contexts/osmesa.cpp"), std::regex("USE\\((\\w+)\\)"));
  for (const std::string& name : called) EXPECT_TRUE(has.contains(name)) << "gl" << name;
}

}  // namespace
}  // namespace ray

// A page of commands and code that nobody runs is soon wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace {

namespace fs = std::filesystem;

/// What follows `start` in each line of a file that begins with it.
std::set<std::string> LinesAfter(const std::regex& start, const fs::path& file) {
  std::set<std::string> rests;
  std::ifstream in(file);
  std::smatch found;
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, found, start, std::regex_constants::match_continuous)) rests.insert(found.suffix());
  return rests;
}

std::vector<fs::path> Tables() {
  std::vector<fs::path> tables;
  for (const char* folder : {"R2", "R3", "source"})
    for (const auto& entry : fs::recursive_directory_iterator(project::Root() / folder))
      if (entry.path().extension() == ".def") tables.push_back(entry.path());
  return tables;
}

/// The sources that `make unit` compiles for a test.
std::vector<std::string> SourcesOfUnit(const std::string& test) {
  const ray::testing::TemporaryFolder folder;  // of its own, since other tests may ask at the same time
  const fs::path list(folder / "sources");
  const std::string command =
      "'" + (project::Root() / "script/unit_sources.sh").string() + "' " + test + " > '" + list.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream in(list);
  const std::vector<std::string> sources{std::istream_iterator<std::string>(in), {}};
  return sources;
}

// A unit once lacked the readers of scenes, which formats.def names and other folders define, and did not link.
TEST(Contributing, UnitsHaveWhatTheTablesNameThatTheyInclude) {
  std::set<std::string> constants;
  for (const char* test : {"grader/tests/Mistakes.cpp", "tests/source/view/panels/Panels.cpp"})
    for (const std::string& source : SourcesOfUnit(test))
      constants.merge(LinesAfter(std::regex("(extern )?const \\w+ "), project::Root() / source));
  ASSERT_GT(Tables().size(), 9u);
  for (const fs::path& table : Tables())
    for (const std::string& row : LinesAfter(std::regex("[A-Z_]+\\("), table)) {
      const std::string kind = row.substr(0, row.find_first_of(",)")) + "_";
      const auto definition = constants.lower_bound(kind);
      EXPECT_TRUE(definition != constants.end() && definition->starts_with(kind)) << table << ": " << row;
    }
}

// A file without a header of its own is found by the first one of its folder that it includes.
TEST(Contributing, UnitsHaveWhatHeadersDeclareAndOtherFilesDefine) {
  for (const auto& [test, wanted] :
       {std::pair{"tests/source/integrate/shading/ShadingPoint.cpp", "source/parse/document/json.cpp"},
        std::pair{"tests/source/integrate/shading/ShadingPoint.cpp", "source/parse/document/yaml.cpp"},
        std::pair{"grader/tests/Grader.cpp", "grader/Judge.cpp"}}) {
    const std::vector<std::string> sources = SourcesOfUnit(test);
    EXPECT_EQ(std::count(sources.begin(), sources.end(), wanted), 1) << test << " lacks " << wanted;
  }
}

TEST(Contributing, EveryScriptRunsAndMakeKnowsEveryTargetItLists) {
  if (!std::getenv("RAYPRO") || !std::getenv("RAYIMG")) GTEST_SKIP() << "RAYPRO or RAYIMG is not set";
  const std::string command = "'" + (project::Root() / "tests/scripts.sh").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

TEST(Contributing, ItsExampleShapeRendersAndItsCommandsExist) {
  const char* const program = std::getenv("RAYPRO");
  const fs::path root = project::Root();
  const fs::path build = program ? fs::path(program).parent_path().lexically_relative(root) : fs::path();
  if (build.empty() || build.native().starts_with("..")) GTEST_SKIP() << "the build is not below the sources";
  const std::string command = "'" + (root / "tests/contributing.sh").string() + "' '" + build.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace

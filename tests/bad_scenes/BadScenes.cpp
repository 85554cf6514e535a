// Every file of this folder and of yaml/ and json/ holds one mistake. The comment at its top is the report that its
// author must see, word for word; JSON has no comments, so there it is a file .txt beside it. Only lists of everything
// that exists are written <every ...>, so that a new shape needs no change here.

#include <gtest/gtest.h>

#include <fstream>

#include "R2/ImageFile.h"
#include "source/app/options/SceneSettings.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/scn/Command.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

std::string Joined(std::span<const std::string_view> names) {
  std::string joined;
  for (const std::string_view name : names) joined += (joined.empty() ? "" : ", ") + std::string(name);
  return joined;
}

std::string ImageKinds() {
  std::vector<std::string_view> names;
  for (const R2::ImageFormat& format : R2::ImageFormats()) names.push_back(format.name);
  return Joined(names);
}

std::string Replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t i = 0; (i = text.find(what, i)) != std::string::npos; i += by.size())
    text.replace(i, what.size(), by);
  return text;
}

/// The lines of a file, or those behind "# " at its top.
std::string LinesOf(const std::filesystem::path& file, bool of_comment) {
  std::ifstream lines(file);
  std::string all, line;
  while (std::getline(lines, line) && (!of_comment || line.starts_with("# ")))
    all += (all.empty() ? "" : "\n") + (of_comment ? line.substr(2) : line);
  return all;
}

std::string Expected(const std::filesystem::path& file) {
  const bool is_json = file.extension() == ".json";
  std::string expected = LinesOf(is_json ? std::filesystem::path(file).replace_extension(".txt") : file, !is_json);
  expected = Replaced(expected, "<every command>", Joined(CommandNames()));
  expected = Replaced(expected, "<every image kind>", ImageKinds());
  return Replaced(expected, "<every mesh kind>", MeshExtensions());
}

/// Compares each file of the folder with that extension; gives how many there were.
std::size_t CheckReports(const std::filesystem::path& folder, const std::string& extension) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != extension) continue;
    ++count;
    std::string report = "(no error)";
    try {
      ParseOptions options;
      options.problem_of = ProblemOf;
      WithSettingsOf(Parse(entry.path(), options).scene, RenderOptions());
    } catch (const SceneErrors& errors) {
      report = Replaced(errors.what(), folder.string() + "/", "");
      report = Replaced(report, folder.lexically_normal().string() + "/", "");
    }
    EXPECT_EQ(report, Expected(entry.path())) << entry.path();
  }
  return count;
}

TEST(BadScenes, EachIsReportedAsItsFirstCommentSays) {
  EXPECT_GE(CheckReports(project::Root() / "tests/bad_scenes", ".scn"), 100u);
}

#ifdef RAYPRO_YAML
TEST(BadScenes, EachInYamlIsReportedWordForWord) {
  EXPECT_GE(CheckReports(project::Root() / "tests/bad_scenes/yaml", ".yaml"), 50u);
}
#endif

TEST(BadScenes, EachInJsonIsReportedWordForWord) {
  EXPECT_GE(CheckReports(project::Root() / "tests/bad_scenes/json", ".json"), 40u);
}

TEST(BadScenes, EveryCommandIsTheSubjectOfOne) {
  std::string all;
  for (const auto& entry : std::filesystem::directory_iterator(project::Root() / "tests/bad_scenes"))
    if (entry.path().extension() == ".scn") all += "\n" + entry.path().filename().string();
  for (const std::string_view command :
       {"material", "begin", "end", "include", "camera", "background", "ambient", "mesh", "line", "tri", "box",
        "sphere", "cylinder", "cone", "dir_light", "point_light", "spot_light", "area_light"})
    EXPECT_TRUE(Contains(all, "\n" + std::string(command) + "_")) << command;
}

}  // namespace
}  // namespace ray

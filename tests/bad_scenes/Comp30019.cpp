// COMP30019's language has no comments, so that the report of txt/mistake.txt, word for word, is in txt/mistake.report.

#include <gtest/gtest.h>

#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

std::string WithoutFolder(std::string report, const std::string& folder) {
  for (std::size_t i; (i = report.find(folder)) != std::string::npos;) report.erase(i, folder.size());
  return report;
}

std::string ReportOfComp30019(const std::filesystem::path& scene) {
  try {
    Parse(scene, {});
    return "(no error)\n";
  } catch (const SceneErrors& errors) {
    const std::string folder = scene.parent_path().string() + "/";
    return WithoutFolder(errors.what(), folder) + "\n";
  }
}

std::vector<std::filesystem::path> BadScenesOfComp30019() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry :
       std::filesystem::directory_iterator((project::Root() / "tests/bad_scenes/txt").lexically_normal()))
    if (entry.path().extension() == ".txt") scenes.push_back(entry.path());
  return scenes;
}

TEST(Comp30019BadScenes, EachIsReportedAsTheFileBesideItSays) {
  const auto scenes = BadScenesOfComp30019();
  for (const auto& scene : scenes) {
    auto expected = scene;
    EXPECT_EQ(ReportOfComp30019(scene), project::BytesOf(expected.replace_extension(".report"))) << scene;
  }
  EXPECT_GE(scenes.size(), 55u);
}

TEST(Comp30019BadScenes, EveryKindOfLineIsTheSubjectOfOne) {
  std::string first_words;
  for (const auto& scene : BadScenesOfComp30019()) first_words += " " + scene.filename().string();
  for (const char* subject : {"material", "light", "plane", "sphere", "triangle", "model"})
    EXPECT_TRUE(Contains(first_words, std::string(" ") + subject + "_")) << subject;
}

}  // namespace
}  // namespace ray

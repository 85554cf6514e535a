#include "grader/Suite.h"

#include <gtest/gtest.h>

#include "grader/Grader.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

struct SuiteFolder : TemporaryFolder {
  SuiteFolder() { WriteFile(*this / "a.scn", small_scene); }
  std::string Write(const std::string& text) const { return WriteFile(*this / "suite.yaml", text); }
};

std::string MessageOf(const std::string& file) {
  return project::MessageOf<SceneErrors>([&] { grade::ReadSuite(file); });
}

TEST(Suite, ScenesInheritTheSettingsBeforeThem) {
  const SuiteFolder place;
  const auto suite = grade::ReadSuite(place.Write("width: 30\npoints: 2\nscenes:\n  - {scene: a.scn, width: 40}\n"));
  ASSERT_EQ(suite.scenes.size(), 1U);
  EXPECT_EQ(suite.scenes[0].width, 40);
  EXPECT_EQ(suite.scenes[0].points, 2);
  EXPECT_EQ(suite.scenes[0].name, "a");
}

TEST(Suite, AMissingSceneIsReportedAtItsPlace) {
  const SuiteFolder place;
  const std::string message = MessageOf(place.Write("scenes:\n  - scene: b.scn\n"));
  EXPECT_TRUE(Has(message, "suite.yaml:2:12: error")) << message;
  EXPECT_TRUE(Has(message, "^")) << message;
}

TEST(Suite, SeveralMistakesAreReportedAtOnce) {
  const SuiteFolder place;
  const std::string message = MessageOf(place.Write("seconds: -1\nscenes:\n  - {scene: a.scn, points: many}\n"));
  EXPECT_TRUE(Has(message, "seconds")) << message;
  EXPECT_TRUE(Has(message, "points")) << message;
}

TEST(Suite, AnUnknownKeyCausesAWarning) {
  const SuiteFolder place;
  const auto suite = grade::ReadSuite(place.Write("widht: 3\nscenes:\n  - scene: a.scn\n"));
  ASSERT_EQ(suite.warnings.size(), 1U);
  EXPECT_TRUE(Has(suite.warnings[0], "suite.yaml:1:1: warning: unknown key 'widht'")) << suite.warnings[0];
  EXPECT_TRUE(Has(suite.warnings[0], "'width'")) << suite.warnings[0];
}

TEST(Suite, SyntaxErrorsHaveAPlace) {
  const SuiteFolder place;
  EXPECT_TRUE(Has(MessageOf(place.Write("scenes: [\n")), "suite.yaml:")) << MessageOf(place.Write("scenes: [\n"));
}

TEST(Suite, TwoScenesWithTheSameNameAreRejected) {
  const SuiteFolder place;
  EXPECT_TRUE(Has(MessageOf(place.Write("scenes:\n  - scene: a.scn\n  - scene: a.scn\n")), "another scene"));
}

TEST(Suite, ANewSuiteOfAFolderCanBeRead) {
  const SuiteFolder place;
  place.Write(grade::NewSuite(place.Path().string()));
  EXPECT_EQ(grade::ReadSuite(place / "suite.yaml").scenes.size(), 1U);
}

TEST(Suite, ANewSuiteNamesFilesOfAnyName) {
  const SuiteFolder place;
  WriteFile(place / "b: #1 \"x\".scn", small_scene);
  place.Write(grade::NewSuite(place.Path().string()));
  EXPECT_EQ(grade::ReadSuite(place / "suite.yaml").scenes[1].name, "b: #1 \"x\"");
}

TEST(Suite, ReadableFilesMustExist) {
  const SuiteFolder place;
  const std::string message = MessageOf(place.Write("readable: [nowhere]\nscenes:\n  - scene: a.scn\n"));
  EXPECT_TRUE(Has(message, "suite.yaml:1:12: error")) << message;
}

TEST(Suite, ImagesAreLimitedTo4096PixelsOnASide) {
  const SuiteFolder place;
  const std::string message = MessageOf(place.Write("width: 5000\nscenes:\n  - scene: a.scn\n"));
  EXPECT_TRUE(Has(message, "suite.yaml:1:8: error")) << message;
}

TEST(Suite, ASeedDecidesTheVariation) {
  grade::SuiteScene scene;
  scene.name = "a";
  scene.vary = {{"sphere -1", "sphere {1..2}", {}}};
  const std::string text = "camera\nsphere -1 0";
  EXPECT_EQ(Varied(text, scene, 3), Varied(text, scene, 3));
  EXPECT_NE(Varied(text, scene, 3), Varied(text, scene, 4));
  EXPECT_TRUE(Has(Varied(text, scene, 3), "camera\nsphere 1."));
}

TEST(Suite, ATextToBeVariedMustOccurOnce) {
  grade::SuiteScene scene;
  scene.vary = {{"1", "2", {}}};
  EXPECT_THROW(Varied("1 1", scene, 3), SceneErrors);
  EXPECT_THROW(Varied("3", scene, 3), SceneErrors);
}

}  // namespace
}  // namespace ray::testing

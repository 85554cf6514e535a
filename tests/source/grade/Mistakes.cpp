#include "source/grade/Mistake.h"

#include <gtest/gtest.h>

#include <set>

#include "source/accelerate/Accelerator.h"
#include "source/app/raygrade/LoadScene.h"
#include "source/grade/Grader.h"
#include "source/grade/Matrix.h"
#include "source/grade/RuledShading.h"
#include "source/render/Render.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

grade::Suite SuiteNamed(const std::string& course) {
  return grade::ReadSuite((project::Root() / "share/suites" / course / "suite.yaml").string());
}

/// The suite with small images, so that a test takes a second.
grade::Suite SmallSuite(const std::string& course) {
  grade::Suite suite = SuiteNamed(course);
  for (grade::SuiteScene& scene : suite.scenes) scene.width = scene.width / 2, scene.height = scene.height / 2;
  return suite;
}

TEST(Mistakes, EachHasANameOfItsOwnAndWordsThatTeach) {
  std::set<std::string> names;
  for (const grade::Mistake* mistake : grade::Mistakes()) {
    EXPECT_TRUE(names.insert(mistake->name).second) << mistake->name;
    EXPECT_GT(std::string(mistake->expected).size(), 20U) << mistake->name;
    EXPECT_GT(std::string(mistake->hint).size(), 10U) << mistake->name;
  }
  EXPECT_GE(names.size(), 35U);
}

TEST(Mistakes, RulesOfTheEquationGiveTheImageOfModeWhitted) {
  for (const char* course : {"cos426", "cs315", "comp30019"}) {
    const grade::Suite suite = SmallSuite(course);
    for (const grade::SuiteScene& of : suite.scenes) {
      const grade::SceneToRender loaded = raygrade::LoadScene(of, of.file);
      const World world(loaded.scene);
      const auto accelerator = FindAcceleratorKind("auto")->Make(world, loaded.accelerator);
      const TraceSettings trace = TraceSettingsOf(loaded.settings);
      const grade::RuledShading ruled(world, *accelerator, trace, {});
      const R2::Image expected = Render(world, *accelerator, loaded.settings).image;
      const R2::Image actual = Render(world, ruled, loaded.settings).image;
      for (std::size_t i = 0; i < expected.Channels().size(); ++i)
        ASSERT_NEAR(actual.Channels()[i], expected.Channels()[i], 1e-6) << of.file;
    }
  }
}

class MistakesOfCourse : public ::testing::TestWithParam<const char*> {};

TEST_P(MistakesOfCourse, AreNeverNamedWronglyAndNearlyAlwaysNamed) {
  const grade::Suite suite = SmallSuite(GetParam());
  grade::Grader grader(suite, {}, raygrade::LoadScene);
  const grade::MatrixCounts counts = TryMistakes(grader.Scenes(), 0);
  std::string lines;
  for (const std::string& line : counts.lines) lines += line + "\n";
  EXPECT_EQ(counts.wrong, 0) << lines;
  EXPECT_LE(counts.silent, counts.right / 20) << lines;
  EXPECT_GT(counts.right, 50) << lines;
}
INSTANTIATE_TEST_SUITE_P(Suites, MistakesOfCourse, ::testing::Values("cs315", "infogr"));

TEST(Mistakes, TheCos426SuiteShowsAtLeast60) {
  const grade::Suite suite = SmallSuite("cos426");
  grade::Grader grader(suite, {}, raygrade::LoadScene);
  int visible = 0;
  for (const grade::Mistake* mistake : grade::Mistakes()) {
    bool is_seen = false;
    for (const auto& images : grader.Scenes()) is_seen |= IsVisible(*images, {mistake});
    visible += is_seen;
  }
  EXPECT_GE(visible, 60);
}

TEST(Mistakes, AnotherCorrectProgramMakesNone) {
  const grade::Suite suite = SmallSuite("cos426");
  grade::Grader grader(suite, {}, raygrade::LoadScene);
  for (const auto& images : grader.Scenes()) {
    grade::SceneResult result;
    result.points = 1;
    Judge({images->AsOfAnother({})}, false, suite, *images, result);
    EXPECT_EQ(result.outcome, grade::SceneResult::Outcome::right) << images->scene().name << result.headline;
  }
}

}  // namespace
}  // namespace ray::testing

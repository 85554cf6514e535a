#include "grader/Grader.h"

#include <gtest/gtest.h>

#include "grader/raygrade/LoadScene.h"
#include "grader/Base64.h"
#include "grader/Html.h"
#include "grader/Reports.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

/// AddressSanitizer reserves 20 TiB of address space; ThreadSanitizer does not start with any limit on it.
#define NEEDS_A_PROGRAM_TO_GRADE() \
  NEEDS_THE_PROGRAM();             \
  NEEDS_NO_THREAD_SANITIZER("raypro cannot run under the limit on memory of graded programs")

namespace ray::testing {
namespace {

using Outcome = grade::SceneResult::Outcome;

grade::Suite MirrorSuite() {
  grade::Suite suite = grade::ReadSuite((project::Root() / "share/suites/cs315/suite.yaml").string());
  std::erase_if(suite.scenes, [](const grade::SuiteScene& scene) { return scene.name != "mirrors"; });
  return suite;
}

/// Grades raypro as a student's program, with more options.
grade::StudentResult GradeRaypro(const std::vector<std::string>& more, std::uint64_t seed = 0) {
  grade::Suite suite = MirrorSuite();
  if (project::has_address_sanitizer) suite.memory = 0x1p30;  // MiB
  grade::GraderSettings settings;
  settings.seed = seed;
  settings.command = With({ProgramName(), "{scene}", "{image}", "-width", "{width}", "-height", "{height}"}, more);
  grade::Grader grader(suite, settings, raygrade::LoadScene);
  return grader.Grade("student", "", [](const grade::StudentResult&) {});
}

TEST(Grader, ARightProgramHasAllPoints) {
  NEEDS_A_PROGRAM_TO_GRADE();
  const auto result = GradeRaypro({});
  EXPECT_EQ(result.scenes[0].outcome, Outcome::right) << result.scenes[0].headline << result.scenes[0].program_output;
  EXPECT_EQ(result.Score(), result.Points());
  EXPECT_TRUE(result.is_complete);
}

TEST(Grader, SmoothedEdgesAreRight) {
  NEEDS_A_PROGRAM_TO_GRADE();
  EXPECT_EQ(GradeRaypro({"-samples", "16"}).scenes[0].outcome, Outcome::right);
}

TEST(Grader, AMistakeIsNamedAndEarnsPartialCredit) {
  NEEDS_A_PROGRAM_TO_GRADE();
  const auto scene = GradeRaypro({"-max_depth", "2"}).scenes[0];
  EXPECT_EQ(scene.mistakes, "one_bounce_less") << scene.headline;
  EXPECT_GE(scene.score, 0.5 * scene.points);
  EXPECT_LT(scene.score, scene.points);
  EXPECT_TRUE(Has(scene.ray_tree, "reflection ray")) << scene.ray_tree;
}

TEST(Grader, TwoMistakesAreNamedTogether) {
  NEEDS_A_PROGRAM_TO_GRADE();
  const auto scene = GradeRaypro({"-max_depth", "2", "-shadows", "off"}).scenes[0];
  EXPECT_TRUE(Has(scene.mistakes, "one_bounce_less") && Has(scene.mistakes, "no_shadows")) << scene.mistakes;
}

TEST(Grader, AnImageOfAnotherSizeIsReported) {
  NEEDS_A_PROGRAM_TO_GRADE();
  const auto scene = GradeRaypro({"-width", "90", "-height", "120"}).scenes[0];
  EXPECT_EQ(scene.outcome, Outcome::failed);
  EXPECT_TRUE(Has(scene.headline, "swapped")) << scene.headline;
}

TEST(Grader, ResultsSurviveWritingAndReading) {
  NEEDS_A_PROGRAM_TO_GRADE();
  const auto result = GradeRaypro({"-max_depth", "2"});
  const std::string json = ResultsJson(result, "suite 1");
  const auto again = grade::ReadResultsJson(json, "suite 1");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->Score(), result.Score());
  EXPECT_EQ(grade::ClassCsv({*again}), grade::ClassCsv({result}));
  EXPECT_FALSE(grade::ReadResultsJson(json, "suite 2"));
  EXPECT_FALSE(grade::ReadResultsJson("{}", "suite 1"));
  std::string damaged = json;
  damaged.replace(damaged.find("\"known\""), 7, "\"other\"");
  EXPECT_FALSE(grade::ReadResultsJson(damaged, "suite 1"));
}

/// Returns a student with some points in one scene, and a remark.
grade::StudentResult StudentWith(const std::string& name, double score, const std::string& note) {
  grade::StudentResult student{.name = name, .scenes = {}};
  student.scenes.resize(1);
  student.scenes[0].scene = "mirrors";
  student.scenes[0].points = 8, student.scenes[0].score = score, student.scenes[0].note = note;
  return student;
}

TEST(Grader, TheClassHasItsMaximumMeanAndMedian) {
  std::vector<grade::StudentResult> students{StudentWith("amy", 7, ""), StudentWith("bob", 1, "time-out"),
                                             StudentWith("cat", 2, "")};
  students[0].scenes[0].mistakes = students[2].scenes[0].mistakes = "no_shadows";
  const std::string csv = ClassCsv(students), page = ClassPage(students, MirrorSuite());
  EXPECT_TRUE(Has(csv, "(maximum),mirrors,8,7,") && Has(csv, "(median),mirrors,8,2,")) << csv;
  EXPECT_TRUE(Has(csv, "(mean),mirrors,8,3.333,")) << csv;
  EXPECT_TRUE(Has(csv, "bob,mirrors,8,1,failed,,time-out,")) << csv;
  EXPECT_TRUE(Has(page, "no_shadows<td><span class=\"bar\" style=\"width:2em\"></span> 2<td>"
                        "<a href=\"amy/index.html\">amy</a>, <a href=\"cat/index.html\">cat</a>"))
      << page;
  students.pop_back();
  EXPECT_TRUE(Has(ClassCsv(students), "(median),mirrors,8,4,"));
}

TEST(Grader, PagesContainNoScriptsAndNoForeignMarkup) {
  grade::StudentResult student{.name = "<script>", .scenes = {}};
  const std::string page = StudentPage(student, MirrorSuite(), "");
  EXPECT_FALSE(Has(page, "<script")) << page;
  EXPECT_TRUE(Has(page, "&lt;script&gt;"));
}

TEST(Base64, MatchesTheExamplesOfItsStandard) {
  const auto of = [](const std::string& text) {
    return grade::Base64(std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace ray::testing

#include "grader/Mistake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "source/accelerate/Accelerator.h"
#include "grader/raygrade/LoadScene.h"
#include "grader/Changes.h"
#include "grader/Grader.h"
#include "grader/Judge.h"
#include "grader/Matrix.h"
#include "grader/RuledShading.h"
#include "source/render/Render.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

grade::Suite SuiteNamed(const std::string& course) {
  return grade::ReadSuite((project::Root() / "share/suites" / course / "suite.yaml").string());
}

/// Returns the suite with small images, so that a test takes a second.
grade::Suite SmallSuite(const std::string& course) {
  grade::Suite suite = SuiteNamed(course);
  for (grade::SuiteScene& scene : suite.scenes) scene.width = scene.width / 2, scene.height = scene.height / 2;
  return suite;
}

TEST(Mistakes, EachHasAUniqueNameAndAHint) {
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

// Mistakes are applied to copies of one scene: a loss in a copy would look like a mistake of the student.
TEST(Mistakes, ACopiedSceneIsRenderedAsTheOriginal) {
  for (const char* course : {"cos426", "groningen", "cs315", "comp30019", "infogr"}) {
    const grade::Suite suite = SmallSuite(course);
    for (const grade::SuiteScene& of : suite.scenes) {
      const grade::SceneToRender loaded = raygrade::LoadScene(of, of.file);
      const Scene copy = grade::Copied(loaded.scene);
      const auto rendered = [&](const Scene& scene) {
        const World world(scene);
        const auto accelerator = FindAcceleratorKind("auto")->Make(world, loaded.accelerator);
        return Render(world, *accelerator, loaded.settings).image;
      };
      EXPECT_EQ(rendered(copy).Channels(), rendered(loaded.scene).Channels()) << of.file;
    }
  }
}

TEST(Mistakes, NoneChangesItsSourceScene) {
  const grade::Suite suite = SmallSuite("cos426");
  const grade::SuiteScene& of = suite.scenes.front();
  const grade::SceneToRender loaded = raygrade::LoadScene(of, of.file);
  grade::Variant variant(loaded.scene, loaded.settings);
  EXPECT_EQ(&variant.scene(), &loaded.scene);
  variant.OwnScene().materials.at(0).kd = {};
  EXPECT_NE(&variant.scene(), &loaded.scene);
  EXPECT_NE(loaded.scene.materials.at(0).kd, R2::Color());
}

class MistakesOfCourse : public ::testing::TestWithParam<const char*> {};

TEST_P(MistakesOfCourse, AreNeverNamedWronglyAndNearlyAlwaysNamed) {
  using enum grade::MatrixRow::Outcome;
  const grade::Suite suite = SmallSuite(GetParam());
  grade::Grader grader(suite, {}, raygrade::LoadScene);
  // Of two of these pairs, only one half was named in cs315: the other half filled an image with one color, or changed
  // only steep shading.
  const grade::MatrixCounts counts = TryMistakes(grader.Scenes(), suite, 4);
  std::string lines;
  for (const grade::MatrixRow& row : counts.rows) lines += row.Text() + "\n";
  EXPECT_EQ(counts.Count(wrong), 0) << lines;
  EXPECT_LE(counts.Count(silent) + counts.Count(same_image), counts.Count(by_name) / 10) << lines;
  EXPECT_GT(counts.Count(by_name), 60) << lines;
}
INSTANTIATE_TEST_SUITE_P(Suites, MistakesOfCourse, ::testing::Values("cs315", "infogr"));

// A smaller change is lost within the tolerance of the suite.
TEST(Mistakes, EachChangesTwoPercentOfASceneOfTheCos426Suite) {
  const grade::Suite suite = SuiteNamed("cos426");
  grade::Grader grader(suite, {}, raygrade::LoadScene);
  for (const grade::Mistake* mistake : grade::Mistakes()) {
    double most = 0;
    for (const auto& images : grader.Scenes()) most = std::max(most, PercentChanged(*images, {mistake}));
    EXPECT_GE(most, 2) << mistake->name;
  }
}

/// Judges a student who submitted only this image.
grade::SceneResult Judged(const R2::Image& student, const grade::Suite& suite, grade::SceneImages& images,
                          grade::StudentVerdict* verdict = nullptr) {
  grade::StudentResult result;
  result.scenes.resize(1);
  result.scenes[0].points = 1;
  const grade::HandedIn handed_in{&images, {student}};
  JudgeTogether({&handed_in, 1}, suite, result);
  if (verdict) *verdict = result.verdict;
  return result.scenes[0];
}

/// A scene of a suite, at its full size.
struct OneScene {
  OneScene(const std::string& course, const std::string& scene) : suite(SuiteNamed(course)) {
    std::erase_if(suite.scenes, [&](const grade::SuiteScene& one) { return one.name != scene; });
    grader.emplace(suite, grade::GraderSettings{}, raygrade::LoadScene);
  }
  grade::SceneImages& Images() { return *grader->Scenes().at(0); }
  grade::Suite suite;
  std::optional<grade::Grader> grader;
};

// A program of Groningen without a normal buffer showed ambient light instead, and raygrade named a camera that looks
// backwards: that image is black, and black was closer to the dark image than normals were.
TEST(Mistakes, DarkImagesAreNotTakenForBlack) {
  OneScene scene("groningen", "normals");
  R2::Image dim = scene.Images().Reference();
  for (int y = 0; y < dim.Height(); ++y)
    for (int x = 0; x < dim.Width(); ++x)
      if (Luminance(dim.At(x, y)) > 0) dim.Set(x, y, {0.06, 0.16, 0.14});
  const grade::SceneResult result = Judged(dim, scene.suite, scene.Images());
  EXPECT_EQ(result.outcome, grade::SceneResult::Outcome::different) << result.headline;
}

const grade::Mistake* MistakeNamed(std::string_view name) {
  return *std::ranges::find_if(grade::Mistakes(), [&](const auto* one) { return one->name == name; });
}

// Edges moved by half a pixel leave dark specks, which were mistaken for shadow acne.
TEST(Mistakes, RaysThroughCornersAreNoMistake) {
  static constexpr auto shifted_by = [](grade::Variant& variant, double right, double up) {
    R2::Vector& shift = variant.OwnScene().camera.shift;
    shift = {shift.x + right / variant.settings.width, shift.y + up / variant.settings.width};
  };
  const auto corner_of = [](const char* name, void (*make)(grade::Variant&)) {
    return grade::Mistake{.name = name, .title = "", .expected = "", .hint = "", .make = make};
  };
  const grade::Mistake corners[]{corner_of("lower left", [](grade::Variant& v) { shifted_by(v, -1, -1); }),
                                 corner_of("lower right", [](grade::Variant& v) { shifted_by(v, 1, -1); }),
                                 corner_of("upper left", [](grade::Variant& v) { shifted_by(v, -1, 1); }),
                                 corner_of("upper right", [](grade::Variant& v) { shifted_by(v, 1, 1); })};
  for (const grade::Mistake& corner : corners) {
    OneScene scene("cs315", "shadows");
    const auto student = scene.Images().With({&corner});
    const grade::SceneResult result = Judged(*student, scene.suite, scene.Images());
    EXPECT_EQ(result.outcome, grade::SceneResult::Outcome::right) << corner.name << ": " << result.headline;
    EXPECT_TRUE(result.remarks.empty()) << corner.name << ": " << result.remarks[0];
  }
}

TEST(Mistakes, DarkSpecksOnLitSurfacesAreAcne) {
  OneScene scene("cs315", "shadows");
  R2::Image student = scene.Images().Reference();
  for (int y = 1; y < student.Height(); y += 3)
    for (int x = 1 + y % 2; x < student.Width(); x += 4) student.Set(x, y, 0.4 * student.At(x, y));
  const grade::SceneResult result = Judged(student, scene.suite, scene.Images());
  ASSERT_EQ(result.remarks.size(), 1U) << result.headline;
  EXPECT_TRUE(Has(result.remarks[0], "Shadow acne")) << result.remarks[0];
}

// The second mistake was chosen for a first one that stood for another, and light that fades with the square was named.
TEST(Mistakes, TheFirstOfTwoIsSearchedAgain) {
  OneScene scene("groningen", "shadows");
  const R2::Image student =
      scene.Images().AsOfAnother({MistakeNamed("spheres_missing"), MistakeNamed("divided_by_pi")});
  const std::string named = Judged(student, scene.suite, scene.Images()).mistakes;
  EXPECT_TRUE(Has(named, "spheres_missing") && Has(named, "divided_by_pi")) << named;
}

/// Judges a whole suite at its full size.
struct WholeSuite {
  explicit WholeSuite(const std::string& course) : suite(SuiteNamed(course)) {
    grader.emplace(suite, grade::GraderSettings{}, raygrade::LoadScene);
  }
  grade::StudentResult Judged(const std::vector<grade::HandedIn>& handed_in) {
    grade::StudentResult student;
    student.scenes.resize(handed_in.size());
    JudgeTogether(handed_in, suite, student);
    return student;
  }
  std::vector<grade::HandedIn> ImagesWith(const grade::MistakeList& mistakes) {
    std::vector<grade::HandedIn> handed_in;
    for (const auto& images : grader->Scenes())
      handed_in.push_back({images.get(), {images->AsOfAnother(mistakes)}, false, handed_in.size()});
    return handed_in;
  }
  grade::Suite suite;
  std::optional<grade::Grader> grader;
};

// Many bounces change 1.3% of the pixels of one scene after the other mistake, which was named alone.
TEST(Mistakes, AHalfThatLeavesOnePercentIsNotNamedAlone) {
  WholeSuite whole("cos426");
  const grade::MistakeList both{MistakeNamed("first_shape_wins"), MistakeNamed("many_bounces")};
  EXPECT_EQ(whole.Judged(whole.ImagesWith(both)).verdict.mistakes, "first_shape_wins+many_bounces");
}

TEST(Mistakes, ACauseThatLeavesASceneUnexplainedIsNotNamed) {
  WholeSuite whole("cs315");
  auto handed_in = whole.ImagesWith({MistakeNamed("no_shadows")});
  R2::Image& torn = handed_in[3].runs[0];
  for (int y = 0; y < torn.Height(); ++y)
    for (int x = y % 16; x < torn.Width(); x += 7) torn.Set(x, y, {1, 0, 1});
  const grade::StudentResult student = whole.Judged(handed_in);
  EXPECT_EQ(student.verdict.mistakes, "");
  EXPECT_TRUE(Has(student.verdict.headline, "Looks most like: no shadows. But that is not all of it"))
      << student.verdict.headline;
  EXPECT_EQ(student.scenes[1].mistakes, "no_shadows");
  EXPECT_EQ(student.scenes[3].mistakes, "");
}

TEST(Mistakes, ABlackImageAmongRightOnesIsReported) {
  WholeSuite whole("cs315");
  auto handed_in = whole.ImagesWith({});
  handed_in[2].runs[0] = R2::Image(handed_in[2].runs[0].Width(), handed_in[2].runs[0].Height());
  const grade::StudentVerdict verdict = whole.Judged(handed_in).verdict;
  EXPECT_EQ(verdict.headline, "All other images are right.");
  EXPECT_EQ(verdict.remarks.size(), 1U);
}

TEST(Mistakes, AThinSurfaceLitFromBehindShowsAnAbsoluteCosine) {
  OneScene scene("infogr", "spot");
  EXPECT_TRUE(IsVisible(scene.Images(), {MistakeNamed("absolute_cosine")}));
}

TEST(Mistakes, ShadowTerminatorsOnSmoothMeshesAreReported) {
  OneScene scene("cos426", "smooth");
  const auto closed = scene.Images().With({MistakeNamed("no_diffuse"), MistakeNamed("no_highlight")}),
             flat = scene.Images().With({MistakeNamed("flat_shading")});
  R2::Image student = scene.Images().Reference();
  for (int y = 0; y < student.Height(); ++y)
    for (int x = 0; x < student.Width(); ++x) {
      const bool is_smooth = grade::LargestChannel(student.At(x, y) - flat->At(x, y)) > 0.05;
      const bool grazes = grade::LargestChannel(student.At(x, y) - closed->At(x, y)) < 0.25;
      if (is_smooth && grazes) student.Set(x, y, closed->At(x, y));
    }
  const grade::SceneResult result = Judged(student, scene.suite, scene.Images());
  ASSERT_EQ(result.remarks.size(), 1U) << result.headline;
  EXPECT_TRUE(Has(result.remarks[0], "Shadow terminator")) << result.remarks[0];
}

TEST(Mistakes, AnotherCorrectProgramMakesNone) {
  const grade::Suite suite = SmallSuite("cos426");
  grade::Grader grader(suite, {}, raygrade::LoadScene);
  for (const auto& images : grader.Scenes()) {
    const grade::SceneResult result = Judged(images->AsOfAnother({}), suite, *images);
    EXPECT_EQ(result.outcome, grade::SceneResult::Outcome::right) << images->scene().name << result.headline;
  }
}

}  // namespace
}  // namespace ray::testing

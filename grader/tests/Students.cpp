// Correct ray tracers of others, in grader/tests/students: a mistake that raygrade names in their images is one of
// ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "grader/JpegTolerance.h"
#include "grader/Judge.h"
#include "grader/raygrade/LoadScene.h"
#include "grader/Grader.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

/// Their sources, in a place where a sandbox's user may read them.
struct StudentsFolder : TemporaryFolder {
  StudentsFolder() {
    fs::copy(project::Root() / "grader/tests/students", Path());
    fs::permissions(Path(), fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
  }
};

bool Succeeds(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }

/// Expects full points in all scenes of a suite except those that the program does not support, graded with `command`.
void ExpectAllPoints(const std::string& course, const std::vector<std::string>& command, const fs::path& readable,
                     const std::string& unknown = {}) {
  grade::Suite suite = grade::ReadSuite((project::Root() / "share/suites" / course / "suite.yaml").string());
  suite.readable.push_back(readable.string());
  suite.memory = 16384;  // Node reserves far more than it uses
  std::erase_if(suite.scenes, [&](const grade::SuiteScene& scene) { return scene.name == unknown; });
  for (const grade::SuiteScene& scene : suite.scenes) {
    grade::Suite alone = suite;
    alone.scenes = {scene};
    grade::GraderSettings settings{.command = command, .image_extension = "ppm"};
    if (Has(scene.options, "-fresnel")) settings.command.push_back("fresnel");
    grade::Grader grader(alone, settings, raygrade::LoadScene);
    const grade::StudentResult result = grader.Grade("student", "", [](const grade::StudentResult&) {});
    EXPECT_EQ(result.Score(), result.Points()) << scene.file << ": " << result.scenes[0].headline << "\n"
                                               << result.scenes[0].program_output;
  }
}

TEST(Students, ARightProgramInCMakesNoMistakes) {
  if (!Succeeds("cc --version")) GTEST_SKIP() << "there is no C compiler";
  const StudentsFolder place;
  const std::string program = place / "scn";
  ASSERT_TRUE(Succeeds("cc -std=c99 -O2 '" + place / "scn.c" + "' -lm -o '" + program + "'"));
  const std::vector<std::string> command{program, "{scene}", "{image}", "{width}", "{height}"};
  ExpectAllPoints("cos426", command, place.Path(), "smooth");
  ExpectAllPoints("infogr", command, place.Path());
}

TEST(Students, ARightProgramInPythonMakesNoMistakes) {
  if (!Succeeds("python3 --version")) GTEST_SKIP() << "there is no python3";
  const StudentsFolder place;
  ExpectAllPoints("groningen", {"python3", place / "groningen.py", "{scene}", "{image}", "{width}", "{height}"},
                  place.Path());
}

TEST(Students, ARightProgramInJavaScriptMakesNoMistakes) {
  if (!Succeeds("node --version")) GTEST_SKIP() << "there is no Node";
  const StudentsFolder place;
  ExpectAllPoints("cs315", {"node", place / "cs315.mjs", "{scene}", "{image}", "{width}", "{height}"}, place.Path());
}

/// A suite of .scn scenes as grader/tests/students/mistaken.c renders it.
class Stranger {
 public:
  explicit Stranger(const std::string& course)
      : suite_(grade::ReadSuite((project::Root() / "share/suites" / course / "suite.yaml").string())) {
    is_built_ = Succeeds("cc -std=c99 -O2 '" + place_ / "mistaken.c" + "' -lm -o '" + place_ / "mistaken" + "'");
    grader_.emplace(suite_, grade::GraderSettings{}, raygrade::LoadScene);
  }

  bool IsBuilt() const { return is_built_; }
  const grade::Suite& suite() const { return suite_; }

  /// Returns the images of a student whose program gets these arguments: names of mistakes and liberties.
  std::vector<grade::HandedIn> Images(const std::string& words) {
    std::vector<grade::HandedIn> handed_in;
    for (const auto& images : grader_->Scenes()) {
      const grade::SuiteScene& scene = images->scene();
      const std::string file = place_ / "image.ppm";
      const std::string fresnel = Has(scene.options, "-fresnel") ? " fresnel" : "";
      EXPECT_TRUE(Succeeds("'" + place_ / "mistaken" + "' '" + scene.file + "' '" + file + "' " +
                           std::to_string(scene.width) + " " + std::to_string(scene.height) + " " + words + fresnel))
          << words;
      handed_in.push_back({images.get(), {Decode(file).image}, false, handed_in.size()});
    }
    return handed_in;
  }
  grade::StudentResult Judged(const std::vector<grade::HandedIn>& handed_in) const {
    grade::StudentResult student;
    student.scenes.resize(handed_in.size());
    for (grade::SceneResult& scene : student.scenes) scene.points = 1;
    JudgeTogether(handed_in, suite_, student);
    return student;
  }

 private:
  StudentsFolder place_;
  grade::Suite suite_;
  std::optional<grade::Grader> grader_;
  bool is_built_ = false;
};

/// Returns the images as they are after compression; 0: uncompressed.
std::vector<grade::HandedIn> Compressed(std::vector<grade::HandedIn> handed_in, int quality) {
  if (quality == 0) return handed_in;
  for (grade::HandedIn& one : handed_in) {
    for (R2::Image& run : one.runs) run = grade::AsJpeg(run, quality);
    one.is_jpeg = true;
  }
  return handed_in;
}

// 624 verdicts on scenes.
TEST(Students, RightProgramsThatDifferLegallyAreRight) {
  if (!Succeeds("cc --version")) GTEST_SKIP() << "there is no C compiler";
  for (const char* course : {"cos426", "infogr"}) {
    Stranger stranger(course);
    ASSERT_TRUE(stranger.IsBuilt());
    for (const char* liberty : {"", "srgb", "gamma22", "rounded", "other_epsilon", "four_samples", "sixteen_samples",
                                "random_samples", "lower_left", "lower_right", "upper_left", "upper_right"}) {
      const auto images = stranger.Images(liberty);
      for (const int quality : {0, 75, 85, 95}) {
        const grade::StudentResult student = stranger.Judged(Compressed(images, quality));
        const std::string which = std::string(course) + " " + liberty + ", JPEG " + std::to_string(quality) + ": ";
        EXPECT_EQ(student.verdict.mistakes, "") << which;
        for (std::size_t i = 0; i < student.scenes.size(); ++i)
          EXPECT_EQ(student.scenes[i].outcome, grade::SceneResult::Outcome::right)
              << which << images[i].images->scene().name << ": " << student.scenes[i].headline;
      }
    }
  }
}

/// A mistake of the stranger's program, and the correct names for it; empty: it is in no table.
struct Foreign {
  const char* word;
  const char* name;
};

void ExpectNamed(Stranger& stranger, const Foreign& foreign) {
  const auto student = stranger.Judged(stranger.Images(foreign.word));
  EXPECT_EQ(student.verdict.mistakes, foreign.name) << foreign.word << ": " << student.verdict.headline;
}

TEST(Students, MistakesOfAForeignProgramAreNamed) {
  if (!Succeeds("cc --version")) GTEST_SKIP() << "there is no C compiler";
  Stranger stranger("cos426");
  ASSERT_TRUE(stranger.IsBuilt());
  for (const Foreign& foreign : {Foreign{"far_root", "far_root"},
                                 {"first_shape_wins", "first_shape_wins"},
                                 {"emission_per_light", "emission_per_light"},
                                 {"attenuation_swapped", "attenuation_swapped"},
                                 {"distance_squared", "distance_squared"},
                                 {"spot_linear", "spot_linear"},
                                 {"two_bounces_more", "two_bounces_more"},
                                 {"clamp_by_largest", "clamped_by_largest"},
                                 {"mirror_sees_no_background", "mirrors_see_no_background"},
                                 {"up_not_orthogonal", "up_not_orthogonal"},
                                 {"towards_not_unit", "towards_not_normalized"},
                                 {"angle_without_tan", "angle_without_tangent"},
                                 {"whole_aspect", "aspect_in_whole_numbers"},
                                 {"v_flipped", "v_flipped"},
                                 {"pole_y", "pole_along_y"},
                                 {"t_in_lengths_of_each_group", "t_of_each_group"},
                                 {"half_exposure", "scaled"},
                                 {"g_b_r", "channels_permuted"}})
    ExpectNamed(stranger, foreign);
}

// A search among pairs takes seconds for each, so only a part of them is tried unless the environment requests more.
TEST(Students, MistakesOfNoTableAreNotNamed) {
  if (!Succeeds("cc --version")) GTEST_SKIP() << "there is no C compiler";
  Stranger stranger("cos426");
  ASSERT_TRUE(stranger.IsBuilt());
  const std::vector<Foreign> foreign{
      {"glass_sign", ""}, {"no_self_shadow", ""}, {"spot_without_shadow", ""}, {"no_inherited_material", ""},
      {"box_without_top", ""}, {"half_shadow", ""}, {"specular_white", ""}, {"large_epsilon", ""}, {"fog", ""},
      {"mirror_unlit", ""}, {"one_and_a_half", ""}, {"parallelograms", ""}, {"radius_not_squared", ""},
      {"box_normals_by_largest", ""}, {"boxes_cast_no_shadow", ""}, {"brightest_light", ""}, {"clamp_each_term", ""},
      {"diffuse_by_ks", ""}, {"dir_not_unit", ""}, {"direction_unit_in_group", ""}, {"directions_moved", ""},
      {"eye_moved", ""}, {"few_levels", ""}, {"mirror_adds_twice", ""}, {"noise", ""}, {"pixels_less_one", ""},
      {"point_light_from_origin", ""}, {"red_lost", ""}, {"saturated", ""}, {"shadow_takes_ambient", ""},
      {"spot_not_unit", ""}, {"view_not_unit", ""}, {"ambient_doubled", ""}, {"behind_the_eye", ""}};
  const int count = Rounds("RAYTESTS_FOREIGN", 6);
  for (int i = 0; i < std::min(count, static_cast<int>(foreign.size())); ++i)
    ExpectNamed(stranger, foreign[static_cast<std::size_t>(i)]);
}

}  // namespace
}  // namespace ray::testing

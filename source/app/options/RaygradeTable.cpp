#include "source/app/options/RaygradeTable.h"

#include "source/app/options/OptionEntry.h"

namespace ray::raygrade {

// One entry stays one thought.
// clang-format off
std::vector<OptionKind> GradingOptions() {
  constexpr int most_pairs = 1'000'000;
  using enum KnownTo;
  return {
      {"out", raygrade, {}, {}, {"folder"}, FileName{AT(grade.out), FileKind::folder}, "", "grading",
       "folder for the pages and tables; made if it is missing"},
      {"students", raygrade, {}, {}, {"folder"}, FileName{AT(grade.students), FileKind::folder}, "", "grading",
       "grade a class: each folder in this one is a student, and {student} in the command"},
      {"results", raygrade, {}, {}, {"file.json"}, FileName{AT(grade.results), FileKind::json}, "", "grading",
       "results for Gradescope of a single student; by default results.json in -out"},
      {"image", raygrade, {}, {}, {"extension"}, Word{[](ray::Options& o, const std::string& word) {
         o.grade.image = word;
         return R2::FormatForName("x." + word) != nullptr;
       }, [](const ray::Options& o) { return o.grade.image; }, "the extension of an image format"}, "", "grading",
       "extension of the file that {image} names"},
      {"seed", raygrade, {}, {}, {"n"}, ray::Number<std::uint64_t>{AT(grade.seed), 0, ~std::uint64_t{0}}, "", "grading",
       "vary scenes as the suite says, so that stored images are wrong; 0: as they are"},
      {"resume", raygrade, {}, {}, {}, Flag{AT(grade.resume)}, "", "grading",
       "keep the results of students that are complete in -out"},
      {"sandbox", raygrade, {}, {}, {"name"}, OneOfEnum<SandboxMode>(AT(grade.sandbox)), "", "grading",
       "how programs are run; auto: with bubblewrap where it works, else with limits only"},
      {"matrix", raygrade, {}, {}, {}, Flag{AT(grade.matrix)}, "", "suites",
       "try every known mistake in each scene, and print what is said of it"},
      {"pairs", raygrade, {}, {}, {"n"}, ray::Number<int>{AT(grade.pairs), 0, most_pairs}, "", "suites",
       "so many pairs of mistakes for -matrix as well"},
      {"new", raygrade, {}, {}, {"folder"}, FileName{AT(grade.new_suite), FileKind::folder}, "", "suites",
       "print a suite of all scenes in the folder"},
  };
}
// clang-format on

}  // namespace ray::raygrade

#include <memory>
#include <span>
#include <vector>

#include "source/app/Status.h"
#include "source/app/options/AboutOptions.h"
#include "source/app/options/FileNames.h"
#include "source/app/options/OptionEntry.h"
#include "grader/raygrade/Options.h"

#include "R2/ImageFile.h"

namespace ray::raygrade {
namespace {

#define AT(member) AT_OF(GradeOptions, member)

// Each entry stays in one place.
// clang-format off
std::vector<OptionKind> GradingOptions() {
  constexpr int most_pairs = 1'000'000;
  constexpr KnownTo raygrade = KnownTo::one;
  return {
      {"out", raygrade, {}, {}, {"folder"}, FileName{AT(out), FileKind::folder}, "", "grading",
       "folder for the pages and tables; created if missing"},
      {"students", raygrade, {}, {}, {"folder"}, FileName{AT(students), FileKind::folder}, "", "grading",
       "grade a class: each folder in this one is a student, which the command names as {student}"},
      {"build", raygrade, {}, {}, {"command"}, Word{[](ray::Options& o, const std::string& word) {
         As<GradeOptions>(o).build = word;
         return !word.empty();
       }, [](const ray::Options& o) { return As<GradeOptions>(o).build; }, "a line for the shell"}, "", "grading",
       "build each program of -students in a copy of its folder, {student}, as in \"make -C {student}\""},
      {"results", raygrade, {}, {}, {"file.json"}, FileName{AT(results), FileKind::json}, "", "grading",
       "results for Gradescope of a single student; by default results.json in -out"},
      {"image", raygrade, {}, {}, {"extension"}, Word{[](ray::Options& o, const std::string& word) {
         As<GradeOptions>(o).image = word;
         return R2::FormatForName("x." + word) != nullptr;
       }, [](const ray::Options& o) { return As<GradeOptions>(o).image; }, "the extension of an image format"}, "", "grading",
       "extension of the file that {image} names"},
      {"seed", raygrade, {}, {}, {"n"}, ray::Number<std::uint64_t>{AT(seed), 0, ~std::uint64_t{0}}, "", "grading",
       "vary scenes as the suite says, so that stored images are wrong; 0: as they are"},
      {"resume", raygrade, {}, {}, {}, Flag{AT(resume)}, "", "grading",
       "keep the results of students that are complete in -out"},
      {"sandbox", raygrade, {}, {}, {"name"}, OneOfEnum<SandboxMode>(AT(sandbox)), "", "grading",
       "protection from programs; auto: bubblewrap if it works, otherwise limits only"},
      {"matrix", raygrade, {}, {}, {}, Flag{AT(matrix)}, "", "suites",
       "try every known mistake in each scene, and print the verdicts"},
      {"pairs", raygrade, {}, {}, {"n"}, ray::Number<int>{AT(pairs), 0, most_pairs}, "", "suites",
       "number of pairs of mistakes that -matrix also tries"},
      {"new", raygrade, {}, {}, {"folder"}, FileName{AT(new_suite), FileKind::folder}, "", "suites",
       "print a suite of all scenes in the folder"},
  };
}
// clang-format on

#undef AT

const std::vector<OptionKind>& Table() {
  static const std::vector<OptionKind> table = WithAboutOptions<Program::raygrade>(GradingOptions());
  return table;
}

}  // namespace
}  // namespace ray::raygrade

namespace ray {

const Program Program::raygrade{
    .name = "raygrade",
    .file_names = "suite.yaml -- command",
    .summary = "grade students' ray tracers and name their mistakes",
    .description =
        "Runs a ray tracer on the scenes of a suite, compares its images with ours at steady\n"
        "pixels, and names the mistake that causes the difference. In the command, {scene}, {image},\n"
        "{width}, {height} and {student} are replaced. docs/teachers.md says more.\n",
    .examples =
        "  raygrade share/suites/cos426/suite.yaml -- ./student {scene} {image} -width {width} -height {height}\n"
        "  raygrade suite.yaml -students handed_in -out graded -- {student}/tracer {scene} {image}\n"
        "  raygrade suite.yaml -students handed_in -build \"make -C {student}\" -- {student}/tracer {scene} {image}\n"
        "  raygrade suite.yaml -matrix\n"
        "  raygrade -new scenes\n",
    .statuses = {{"0", "Success, whatever the points."},
                 {"1", "Grading failed."},
                 {"2", "Wrong arguments."},
                 {"3", "The suite, or a scene, is wrong or missing."},
                 {"4", "A file cannot be written."}},
    .failed = status::failed,
    .options = raygrade::Table,
    .commands = [] { return std::span<const CommandKind>(); },
    .defaults = []() -> std::unique_ptr<Options> { return std::make_unique<raygrade::GradeOptions>(); },
    .complete =
        [](Options& options, std::span<const std::string>) {
          if (options.request && !options.names.empty()) RefuseName(options.names[0], "");
        }};

}  // namespace ray

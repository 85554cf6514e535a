#include "grader/raygrade/GradeClass.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/files/SceneHash.h"
#include "grader/raygrade/LoadScene.h"
#include "source/app/report/Messages.h"
#include "grader/Grader.h"
#include "grader/Matrix.h"
#include "grader/Reports.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::raygrade {
namespace {

namespace fs = std::filesystem;
using grade::StudentResult;

void WriteText(const std::string& file, const std::string& text) {
  WriteWhole(CheckOutput(file, {}), std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

void MakeFolder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw OutputError("cannot make the folder " + Quoted(folder.string()) + ": " + failed.message());
}

std::vector<std::string> CommandOf(const GradeOptions& options, const grade::Suite& suite) {
  std::vector<std::string> command(options.names.begin() + 1, options.names.end());
  if (command.empty()) command = suite.command;
  if (command.empty()) throw UsageError("no command: write it behind --, as in -- ./student {scene} {image}");
  if (!options.students.empty() &&
      std::ranges::none_of(command, [](const std::string& word) { return word.find("{student}") != word.npos; }))
    throw UsageError("with -students the command needs {student}, the folder of each");
  // Programs run in folders of their own. A program named without a slash is looked for on PATH.
  for (std::string& word : command) {
    std::error_code none;
    const bool has_slash = word.find('/') != word.npos, is_program = &word == &command.front();
    if (fs::exists(word, none) && (has_slash || (!is_program && fs::is_regular_file(word, none))))
      word = fs::absolute(word).lexically_normal().string();
  }
  return command;
}

std::vector<std::string> StudentsIn(const std::string& folder) {
  std::vector<std::string> students;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.is_directory()) students.push_back(entry.path().filename().string());
  if (failed || students.empty()) throw UsageError("-students " + Quoted(folder) + ": there are no folders in it");
  std::ranges::sort(students);
  return students;
}

std::string PointsOf(const StudentResult& student) {
  return Rounded(student.Score(), 4) + " of " + Rounded(student.Points(), 4) + " points";
}

/// Grades one student; what is known is written after each scene.
StudentResult GradeStudent(grade::Grader& grader, const std::string& name, const std::string& folder,
                           const fs::path& out, const std::string& results, const std::string& identity) {
  MakeFolder(out);
  return grader.Grade(name, folder, [&](const StudentResult& so_far) {
    WriteText(results, ResultsJson(so_far, identity));
    WriteText((out / "index.html").string(), StudentPage(so_far, grader.suite(), grader.sandbox().Describe()));
    const grade::SceneResult& last = so_far.scenes.back();
    WriteStandardOutput((name.empty() ? "" : Escaped(name) + ": ") + Escaped(last.scene) + ": " +
                        Rounded(last.score, 4) + "/" + Rounded(last.points, 4) + "  " + Escaped(last.headline) + "\n");
  });
}

/// All that results depend on but a student's program.
std::string IdentityOf(const grade::Grader& grader, const GradeOptions& options, std::span<const std::string> command) {
  std::string text = "raygrade " RAYPRO_VERSION ", suite and scenes " + SceneHash(grader.Inputs()) + ", seed " +
                     std::to_string(options.seed) + ":";
  for (const std::string& word : command) text += " " + Quoted(word);
  return text;
}

/// What an earlier run has found, if that is complete and of the same suite, seed and command.
std::optional<StudentResult> Kept(const fs::path& results, const std::string& identity) {
  std::ifstream file(results, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  auto student = grade::ReadResultsJson(text, identity);
  return student && student->is_complete ? student : std::nullopt;
}

int GradeClass(grade::Grader& grader, const GradeOptions& options, const std::string& identity) {
  const fs::path out = options.out;
  std::vector<StudentResult> students;
  for (const std::string& name : StudentsIn(options.students)) {
    const fs::path page = out / name, results = page / "results.json";
    auto student = options.resume ? Kept(results, identity) : std::nullopt;
    if (!student)
      student = GradeStudent(grader, name, fs::absolute(fs::path(options.students) / name).string(), page,
                             results.string(), identity);
    if (StopSignal() != 0) return status::killed_by + StopSignal();
    students.push_back(std::move(*student));
    for (grade::SceneResult& scene : students.back().scenes) scene.expected = scene.actual = scene.difference = {};
    WriteText((out / "class.csv").string(), ClassCsv(students));
    WriteText((out / "index.html").string(), ClassPage(students, grader.suite()));
  }
  return status::done;
}

int PrintMatrix(grade::Grader& grader, int pairs) {
  const grade::MatrixCounts counts = TryMistakes(grader.Scenes(), pairs);
  for (const std::string& line : counts.lines) WriteStandardOutput(line + "\n");
  WriteStandardOutput("right " + std::to_string(counts.right) + " (" + std::to_string(counts.by_name) +
                      " by name, others by one that looks the same), told to be empty " + std::to_string(counts.told) +
                      ", wrong " + std::to_string(counts.wrong) +
                      ", silent " + std::to_string(counts.silent) + "; in no scene visible: " +
                      Counted(static_cast<std::uint64_t>(counts.invisible), "mistake") + "\n");
  return status::done;
}

grade::Sandbox::Mode ModeOf(SandboxMode mode) { return static_cast<grade::Sandbox::Mode>(mode); }

}  // namespace

int Grade(const GradeOptions& options) {
  if (!options.new_suite.empty()) {
    WriteStandardOutput(grade::NewSuite(options.new_suite));
    return status::done;
  }
  if (options.names.empty()) throw UsageError("no suite is named: raygrade suite.yaml -- command");
  const grade::Suite suite = grade::ReadSuite(options.names[0]);
  for (const std::string& line : suite.warnings) PrintError(line);
  grade::GraderSettings settings{.command = {},
                                 .seed = options.seed,
                                 .sandbox = ModeOf(options.sandbox),
                                 .image_extension = options.image,
                                 .stop = StopRequested()};
  if (!options.matrix) settings.command = CommandOf(options, suite);
  grade::Grader grader(suite, settings, LoadScene);
  if (options.matrix) return PrintMatrix(grader, options.pairs);
  PrintError("raygrade: " + grader.sandbox().Describe());
  CatchInterrupts();
  MakeFolder(options.out);
  const std::string identity = IdentityOf(grader, options, grader.Command());
  if (!options.students.empty()) return GradeClass(grader, options, identity);
  const std::string results =
      options.results.empty() ? (fs::path(options.out) / "results.json").string() : options.results;
  const StudentResult student = GradeStudent(grader, "", "", options.out, results, identity);
  if (StopSignal() != 0) return status::killed_by + StopSignal();
  WriteStandardOutput(PointsOf(student) + "\n");
  return status::done;
}

}  // namespace ray::raygrade

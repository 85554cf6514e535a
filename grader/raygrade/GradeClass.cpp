#include "grader/raygrade/GradeClass.h"

#include <unistd.h>

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

bool HasPlaceholder(const std::string& word) { return word.find('{') != word.npos; }

/// Returns an absolute path for a word that names an existing file, since programs run in separate folders; links
/// within its folder are preserved. Returns other words unchanged.
std::string WithPlace(const std::string& word, bool is_program) {
  std::error_code none;
  const bool has_slash = word.find('/') != word.npos, is_folder = word == "." || word == "..";
  if (!fs::exists(word, none) || !(has_slash || is_folder || (!is_program && fs::is_regular_file(word, none))))
    return word;
  if (fs::is_directory(word, none)) return fs::canonical(word).string();
  return (fs::canonical(fs::absolute(word).parent_path()) / fs::path(word).filename()).string();
}

/// Throws a UsageError if the program of a command does not exist: better once than as a failure of every scene.
void RequireProgram(const std::vector<std::string>& command) {
  const std::string& program = command[0];
  std::error_code none;
  if (HasPlaceholder(program)) return;
  if (program.find('/') != program.npos) {
    if (!fs::is_regular_file(program, none)) throw UsageError("there is no program " + Quoted(program));
    if (access(program.c_str(), X_OK) != 0)
      throw UsageError(Quoted(program) + " is not executable; chmod +x makes it so");
  } else {
    if (std::ranges::none_of(grade::program_folders, [&](const char* folder) {
          return access((std::string(folder) + "/" + program).c_str(), X_OK) == 0;
        }))
      throw UsageError("there is no program " + Quoted(program) + " in " +
                       OneOf({grade::program_folders.begin(), grade::program_folders.end()}) +
                       (fs::exists(program, none) ? "; for the file in this folder, write ./" + program : ""));
  }
  // The script of an interpreter.
  const auto script =
      std::ranges::find_if(command.begin() + 1, command.end(), [](const auto& w) { return !w.starts_with('-'); });
  if (script == command.end() || HasPlaceholder(*script) || fs::path(*script).extension().empty()) return;
  if (!fs::exists(*script, none)) throw UsageError("there is no file " + Quoted(*script) + " for " + program);
}

std::vector<std::string> CommandOf(const GradeOptions& options, const grade::Suite& suite) {
  std::vector<std::string> command(options.names.begin() + 1, options.names.end());
  if (command.empty()) command = suite.command;
  if (command.empty()) throw UsageError("no command: write it after --, as in -- ./student {scene} {image}");
  if (!options.students.empty() &&
      std::ranges::none_of(command, [](const std::string& word) { return word.find("{student}") != word.npos; }))
    throw UsageError("with -students the command needs {student}, the folder of each");
  for (std::string& word : command) word = WithPlace(word, &word == &command.front());
  RequireProgram(command);
  return command;
}

std::vector<std::string> StudentsIn(const std::string& folder) {
  std::vector<std::string> students;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.is_directory()) students.push_back(entry.path().filename().string());
  if (failed || students.empty()) throw UsageError("-students " + Quoted(folder) + ": the folder contains no folders");
  std::ranges::sort(students);
  return students;
}

std::string PointsOf(const StudentResult& student) {
  return Rounded(student.Score(), 4) + " of " + Rounded(student.Points(), 4) + " points";
}

void PrintResult(const StudentResult& student) {
  const std::string begin = student.name.empty() ? "" : Escaped(student.name) + ": ";
  if (!student.problem.empty()) return WriteStandardOutput(begin + "The program " + Escaped(student.problem) + ".\n");
  for (const grade::SceneResult& scene : student.scenes)
    WriteStandardOutput(begin + Escaped(scene.scene) + ": " + Rounded(scene.score, 4) + "/" + Rounded(scene.points, 4) +
                        "  " + Escaped(scene.headline) + "\n");
  WriteStandardOutput(begin + Escaped(student.verdict.headline) + "\n");
}

/// Grades one student; writes the results so far after each scene.
StudentResult GradeStudent(grade::Grader& grader, const std::string& name, const std::string& folder,
                           const fs::path& out, const std::string& results, const std::string& identity) {
  MakeFolder(out);
  return grader.Grade(name, folder, [&](const StudentResult& so_far) {
    WriteText(results, ResultsJson(so_far, identity));
    WriteText((out / "index.html").string(), StudentPage(so_far, grader.suite(), grader.sandbox().Describe()));
    if (so_far.is_complete) PrintResult(so_far);
  });
}

/// Identifies everything that results depend on except a student's program.
std::string IdentityOf(const grade::Grader& grader, const GradeOptions& options, std::span<const std::string> command) {
  std::string text = "raygrade " RAYPRO_VERSION ", suite and scenes " + SceneHash(grader.Inputs()) + ", seed " +
                     std::to_string(options.seed) + ":";
  for (const std::string& word : command) text += " " + Quoted(word);
  const std::string& build = grader.Build();
  return build.empty() ? text : text + ", built by " + Quoted(build);
}

std::string ContentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the result of an earlier run, if it is complete and of the same suite, seed and command.
std::optional<StudentResult> Kept(const fs::path& results, const std::string& identity) {
  auto student = grade::ReadResultsJson(ContentOf(results), identity);
  return student && student->is_complete ? student : std::nullopt;
}

std::string FolderOf(const GradeOptions& options, const std::string& student) {
  return fs::canonical(fs::path(options.students) / student).string();
}

/// Reports missing programs before grading. Throws a UsageError if all are missing.
void RequirePrograms(const grade::Grader& grader, const GradeOptions& options, const std::vector<std::string>& names) {
  if (!grader.Build().empty()) return;
  std::string without, missing;
  std::size_t count = 0;
  for (const std::string& name : names) {
    const std::string file = grader.MissingProgram(FolderOf(options, name));
    if (file.empty()) continue;
    without += (without.empty() ? "" : ", ") + Escaped(name);
    missing = file;
    ++count;
  }
  if (count == names.size())
    throw UsageError("no folder in " + Quoted(options.students) + " has the file " + Quoted(missing) +
                     "; if it has to be built, add -build \"make -C {student}\"");
  if (count > 0) PrintError("raygrade: there is no " + Quoted(missing) + " in the folders of " + without);
}

/// Reads the comment that a teacher has written to a file next to the student's page.
void AddComment(const fs::path& folder, StudentResult& student) {
  student.comment = ContentOf(folder / "comment.txt");
  while (!student.comment.empty() && student.comment.back() == '\n') student.comment.pop_back();
  const std::string page = ContentOf(folder / "index.html"), with = grade::WithComment(page, student.comment);
  if (with != page) WriteText((folder / "index.html").string(), with);
}

int GradeClass(grade::Grader& grader, const GradeOptions& options, const std::string& identity) {
  const fs::path out = options.out;
  std::vector<StudentResult> students;
  const std::vector<std::string> names = StudentsIn(options.students);
  RequirePrograms(grader, options, names);
  for (const std::string& name : names) {
    const fs::path page = out / name, results = page / "results.json";
    auto student = options.resume ? Kept(results, identity) : std::nullopt;
    if (!student) student = GradeStudent(grader, name, FolderOf(options, name), page, results.string(), identity);
    if (StopSignal() != 0) return status::killed_by + StopSignal();
    AddComment(page, *student);
    students.push_back(std::move(*student));
    for (grade::SceneResult& scene : students.back().scenes) scene.expected = scene.actual = scene.difference = {};
    WriteText((out / "class.csv").string(), ClassCsv(students));
    WriteText((out / "index.html").string(), ClassPage(students, grader.suite()));
  }
  return status::done;
}

int PrintMatrix(grade::Grader& grader, int pairs) {
  using enum grade::MatrixRow::Outcome;
  const grade::MatrixCounts counts = TryMistakes(grader.Scenes(), grader.suite(), pairs);
  for (const grade::MatrixRow& row : counts.rows) WriteStandardOutput(row.Text() + "\n");
  const auto count = [&](grade::MatrixRow::Outcome outcome) { return std::to_string(counts.Count(outcome)); };
  WriteStandardOutput("right by name " + count(by_name) + ", by another cause with the same images " +
                      count(same_image) + ", of one color " + count(empty) + ", wrong " + count(wrong) + ", silent " +
                      count(silent) + ", in no scene visible " + count(invisible) + "\n");
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
  if (!options.build.empty() && options.students.empty())
    throw UsageError("-build builds the programs of -students; build a single program before it is graded");
  grade::GraderSettings settings{.command = {},
                                 .build = options.students.empty() ? ""
                                          : options.build.empty()  ? suite.build
                                                                   : options.build,
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

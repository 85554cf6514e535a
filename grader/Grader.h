#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "grader/Judge.h"
#include "grader/Results.h"
#include "grader/SceneImages.h"

namespace ray::grade {

/// Settings for running students' programs.
struct GraderSettings {
  std::vector<std::string> command;  // with {scene}, {image}, {width}, {height} and {student}
  std::string build{};               // a shell command with {student}; empty if programs need no build
  std::uint64_t seed = 0;            // 0: unchanged scenes; otherwise varied as the suite says
  Sandbox::Mode sandbox = Sandbox::Mode::automatic;
  std::string image_extension = "png";
  const std::atomic<bool>* stop = nullptr;  // ends the grading when it becomes true; may be null
};

/// A temporary folder that is deleted with its content.
class ScratchFolder {
 public:
  /// Throws std::runtime_error if none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  const std::filesystem::path& Path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct FetchedImage;

/// Grades programs by a suite. References, and images with mistakes, are rendered once for all of them.
class Grader {
 public:
  /// Copies the scenes to a temporary folder that is deleted with the grader. Throws SceneErrors for a scene that
  /// cannot be read, or a text to be varied that is not in it exactly once.
  Grader(const Suite& suite, const GraderSettings& settings, const Loader& load);

  const Suite& suite() const { return suite_; }
  const Sandbox& sandbox() const { return sandbox_; }
  std::vector<std::unique_ptr<SceneImages>>& Scenes() { return scenes_; }
  const std::vector<std::string>& Command() const { return settings_.command; }
  const std::string& Build() const { return settings_.build; }
  /// Returns the suite and every file that a scene was read from.
  const std::vector<std::string>& Inputs() const { return inputs_; }

  /// Returns the first missing file of a student's folder that the command names; empty if all exist.
  std::string MissingProgram(const std::string& student) const;

  /// Builds the program of a student if settings.build is set, and runs it on every scene. Calls `done` after each
  /// scene with the result so far, so that a grader that is killed loses nothing. If settings.stop ends the run, the
  /// result omits the remaining scenes and is not complete.
  ///   student   the folder for {student}; empty for none
  StudentResult Grade(const std::string& name, const std::string& student,
                      const std::function<void(const StudentResult&)>& done);

 private:
  /// Builds a copy of the folder, which itself stays unchanged.
  ///   result   receives the log, and the problem if there is one
  void BuildCopy(const std::string& student, const std::filesystem::path& copy, StudentResult& result);
  /// Returns the result of a scene before the program is run.
  static SceneResult Begun(const SuiteScene& scene);
  /// Runs a student's program on a scene. Returns its images, empty if it failed; `result` then contains the reason.
  HandedIn GradeScene(SceneImages& images, const std::string& file, const std::string& student, double seconds_left,
                      SceneResult& result);
  /// Runs a student's program once on a scene, and adds its seconds and its output to `result`.
  FetchedImage RunProgram(const SuiteScene& scene, const std::string& file, const std::string& student,
                          double seconds_left, SceneResult& result);
  /// Returns the command with the words in braces replaced by their values.
  std::vector<std::string> FilledCommand(const SuiteScene& scene, const std::string& file, const std::string& student,
                                         const std::filesystem::path& image) const;
  void Stage(const SuiteScene& scene);

  const Suite& suite_;
  GraderSettings settings_;
  Loader load_;
  Sandbox sandbox_;
  ScratchFolder folder_;
  std::vector<std::string> inputs_;
  std::vector<std::string> files_;  // of the scenes, as students see them
  std::vector<std::unique_ptr<SceneImages>> scenes_;
};

/// Returns the text of a scene with its variations; see SuiteScene::vary. Throws SceneErrors.
std::string Varied(const std::string& text, const SuiteScene& scene, std::uint64_t seed);

}  // namespace ray::grade

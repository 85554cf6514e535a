#pragma once

#include <string>
#include <vector>

#include "grader/Comparison.h"
#include "grader/Sandbox.h"

namespace ray::grade {

/// What became of one scene.
struct SceneResult {
  enum class Outcome { right, known_mistake, different, failed };

  std::string scene, title, teaches;
  double points = 0, score = 0;
  Outcome outcome = Outcome::failed;
  std::string headline;              // one sentence, without markup
  std::vector<std::string> remarks;  // more sentences: expectations, hints, what detectors found
  std::string mistakes;              // names of those named, "gamma+mirrored"; empty for none
  std::string note{};                // a word for tables: "acne", "time-out"; may be empty
  double explained = 0;              // share of the difference, 0 to 1, where mistakes are named
  double percent = 0;                // of the steady pixels that differ
  double seconds = 0;
  std::string program_output;  // the beginning, of a program that failed
  // For the page of the student; empty where there is no image.
  R2::Image expected, actual, difference;
  int worst_x = -1, worst_y = -1;
  std::string ray_tree;
};

/// The verdict on all scenes of a student together.
struct StudentVerdict {
  std::string headline;              // a sentence; empty before all scenes are graded
  std::vector<std::string> remarks;  // more sentences: expectations and hints
  std::string mistakes;              // names of the causes, "gamma+mirrored"; empty if none is named
  std::vector<std::string> scenes;   // that show the causes
  std::string best_scene;            // whose worst pixel shows them best; empty if none does
};

/// What became of one student.
struct StudentResult {
  std::string name;
  std::vector<SceneResult> scenes;
  StudentVerdict verdict{};
  std::string comment{};    // the teacher's own, kept in a file beside the page
  std::string problem{};    // why no scene was tried, completing "The program"; empty if the program was there
  std::string build_log{};  // the beginning of the output of the build
  bool is_complete = false;

  double Score() const;
  double Points() const;
};

}  // namespace ray::grade

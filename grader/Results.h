#pragma once

#include <string>
#include <vector>

#include "grader/Comparison.h"
#include "grader/Sandbox.h"

namespace ray::grade {

/// The result of one scene.
struct SceneResult {
  enum class Outcome { right, known_mistake, different, failed };

  std::string scene, title, teaches;
  double points = 0, score = 0;
  Outcome outcome = Outcome::failed;
  std::string headline;              // one sentence, without markup
  std::vector<std::string> remarks;  // more sentences: expectations, hints, findings of detectors
  std::string mistakes;              // names of the mistakes, "gamma+mirrored"; empty if none is named
  std::string note{};                // a word for tables: "acne", "time-out"; may be empty
  double explained = 0;              // share of the difference, 0 to 1, if mistakes are named
  double percent = 0;                // of the steady pixels that differ
  double seconds = 0;
  std::string program_output;  // the beginning of the output of a program that failed
  // The images for the page of the student; empty if there is no image.
  R2::Image expected, actual, difference;
  int worst_x = -1, worst_y = -1;
  std::string ray_tree;
};

/// The verdict on all scenes of a student together.
struct StudentVerdict {
  std::string headline;              // a sentence; empty before all scenes are graded
  std::vector<std::string> remarks;  // more sentences: expectations and hints
  std::string mistakes;              // names of the causes, "gamma+mirrored"; empty if none is named
  std::vector<std::string> scenes;   // the scenes that show the causes
  std::string best_scene;            // the scene whose worst pixel shows them best; empty if none does
};

/// The result of one student.
struct StudentResult {
  std::string name;
  std::vector<SceneResult> scenes;
  StudentVerdict verdict{};
  std::string comment{};    // the teacher's own, stored in a file next to the page
  std::string problem{};    // why no scene was tried, completing "The program"; empty if the program ran
  std::string build_log{};  // the beginning of the output of the build
  bool is_complete = false;

  double Score() const;
  double Points() const;
};

}  // namespace ray::grade

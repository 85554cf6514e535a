#pragma once

#include <string>
#include <vector>

#include "grader/SceneImages.h"

namespace ray::grade {

/// What is said of students who made known mistakes: our own image with the mistakes, from a camera a little aside, and
/// of 8 bits.
struct MatrixCounts {
  int right = 0;      // named, or one that looks the same in the scene
  int by_name = 0;    // of these, named itself
  int told = 0;       // black, or of one color, which a rule says before mistakes are tried
  int wrong = 0;      // another one is named, or something that is not there
  int silent = 0;     // visible, and none is named
  int invisible = 0;  // no scene shows it

  std::vector<std::string> lines;  // one per mistake: its name, then what is said in each scene
};

/// Tries every mistake of the table in each scene; with `pairs` above 0 so many pairs as well, chosen by a seed.
MatrixCounts TryMistakes(std::vector<std::unique_ptr<SceneImages>>& scenes, int pairs);

}  // namespace ray::grade

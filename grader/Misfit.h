#pragma once

#include <optional>

#include "grader/Comparison.h"

namespace ray::grade {

/// How well an image with mistakes fits a student's, over steady pixels away from edges of its own: where exactly these
/// lie is rounding.
struct Fit {
  double squares = 0;  // the sum of squared differences beyond rounding, scaled up to all steady pixels
  double percent = 0;  // of the pixels counted that differ by more than the tolerance
  double specks = 0;   // percent of the pixels counted that are specks of shadow acne; these are not in the others
};

/// One scene of a student: the submission and what it is compared with.
struct Exhibit {
  SceneImages* images;
  Submission student;
  Comparison found;
  bool is_right;
};
Exhibit MakeExhibit(SceneImages& images, Submission student);

/// Returns nothing where too few pixels are away from edges.
///   image   values for a screen
std::optional<Fit> FitOf(const Exhibit& exhibit, const R2::Image& image);

}  // namespace ray::grade

#pragma once

#include <optional>

#include "grader/Comparison.h"

namespace ray::grade {

/// How well an image with mistakes fits a student's, over steady pixels. Where exactly an edge of the image lies is
/// rounding: there a value between those of neighboring pixels fits.
struct Fit {
  double squares = 0;  // the sum of squared differences beyond rounding
  double percent = 0;  // of the steady pixels that differ by more than the tolerance
  double specks = 0;   // percent of the steady pixels that are specks of shadow acne; these are not in the others
};

/// One scene of a student: the submission and what it is compared with.
struct Exhibit {
  SceneImages* images;
  Submission student;
  Comparison found;
  bool is_right;
};
Exhibit MakeExhibit(SceneImages& images, Submission student);

/// Returns nothing if most pixels are at edges, where nearly anything fits.
///   image    values for a screen
///   steady   of the image's own pixels: then only those that are steady count, and edges need no other care
std::optional<Fit> FitOf(const Exhibit& exhibit, const R2::Image& image, const std::vector<bool>* steady = nullptr);

}  // namespace ray::grade

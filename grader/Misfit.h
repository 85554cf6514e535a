#pragma once

#include <optional>

#include "grader/Comparison.h"

namespace ray::grade {

/// The fit of an image with mistakes to a student's, over steady pixels. The exact place of an edge in an image is
/// rounding: there a value between those of neighboring pixels fits.
struct Fit {
  double squares = 0;  // sum of squared differences beyond rounding
  double percent = 0;  // percentage of steady pixels that differ by more than the tolerance
  double specks = 0;   // percentage of steady pixels that are specks of shadow acne, which the others exclude
};

/// One scene of a student: the submission and the images for comparison.
struct Exhibit {
  SceneImages* images;
  Submission student;
  Comparison found;
  bool is_right;
};
Exhibit MakeExhibit(SceneImages& images, Submission student);

/// Returns std::nullopt if most pixels are at edges, where almost anything fits.
///   image    as displayed
///   spread   the change of the image within each of its pixels: if given, a pixel may differ by that much more, and
///            edges need no further care
std::optional<Fit> FitOf(const Exhibit& exhibit, const R2::Image& image, const std::vector<double>* spread = nullptr);

}  // namespace ray::grade

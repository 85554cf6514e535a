#pragma once

#include <optional>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "R2/Plane.h"
#include "grader/SceneImages.h"

namespace ray::grade {

/// How a student's image differs from the reference where that can be relied on.
struct Comparison {
  std::int64_t steady = 0, differing = 0;  // pixels, or blocks of them
  int worst_x = 0, worst_y = 0;            // the pixel in the midst of what differs most, from the lower left
  double worst = 0;                        // the sum of the differences around it
  std::vector<bool> differs;               // by rows from the bottom

  double Percent() const {
    return steady > 0 ? 100.0 * static_cast<double>(differing) / static_cast<double>(steady) : 0;
  }
};

/// A student's image, as it is compared.
struct Submission {
  R2::Image image;                // mean of all runs, values for a screen
  R2::Image cells;                // SceneImages::Cells of it
  std::vector<double> tolerance;  // of each cell: that of the suite, and what noise and compression may add
};

///   compressed   the reference as a file that loses something gives it back; null for files that do not
Submission MakeSubmission(const std::vector<R2::Image>& runs, const R2::Image* compressed, const SceneImages& images);

Comparison Compare(const Submission& student, const SceneImages& images);
///   expected   SceneImages::Cells of an image in place of the reference
Comparison Compare(const Submission& student, const R2::Image& expected, const SceneImages& images);

}  // namespace ray::grade

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

Submission MakeSubmission(const std::vector<R2::Image>& runs, bool is_jpeg, const SceneImages& images);

Comparison Compare(const Submission& student, const SceneImages& images);

/// Which mistakes make an image like the student's.
struct Explanation {
  MistakeList mistakes;      // none: nothing known explains it
  MistakeList alternatives;  // others that explain the first of them as well: the scene cannot tell them apart
  double share = 0;          // of the squared difference that they explain, 0 to 1
};

/// The share that must be explained for a mistake to be named.
inline constexpr double named_above = 0.8;

/// Tries every mistake, and where none explains nearly all, pairs: the mistakes that leave the least of the squared
/// difference over steady pixels, each with every other, and once more the second of the best pair; and all with those
/// of a finished image.
Explanation Explain(const Submission& student, SceneImages& images);

/// The share of the squared difference between student and reference, or between student and black if that is less,
/// that is gone where the reference is made with the mistakes; negative where they make it worse, nothing where they
/// cannot be made in the scene or change nothing.
std::optional<double> ShareExplained(const Submission& student, SceneImages& images, const MistakeList& mistakes);

/// Whether the mistakes change more of the steady pixels than the suite allows.
bool IsVisible(SceneImages& images, const MistakeList& mistakes);

}  // namespace ray::grade

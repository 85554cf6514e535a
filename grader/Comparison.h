#pragma once

#include <vector>

#include "R2/Image.h"
#include "R2/Plane.h"
#include "grader/SceneImages.h"

namespace ray::grade {

/// The differences of a student's image from the reference, over steady pixels.
struct Comparison {
  std::int64_t steady = 0, differing = 0;  // number of pixels, or of blocks
  int worst_x = 0, worst_y = 0;            // the pixel in the middle of the largest difference, from the lower left
  double worst = 0;                        // sum of the differences around it
  std::vector<bool> differs;               // in rows from the bottom

  double Percent() const {
    return steady > 0 ? 100.0 * static_cast<double>(differing) / static_cast<double>(steady) : 0;
  }
};

/// A student's image, prepared for comparison.
struct Submission {
  R2::Image image;                // mean of all runs, as displayed
  R2::Image cells;                // SceneImages::Cells of the image
  // of each cell: that of the suite, plus the change within a pixel, noise, and losses of compression
  std::vector<double> tolerance;
};

/// Prepares a student's image.
///   losses   of compression, by pixel or block; empty for lossless formats
Submission MakeSubmission(const std::vector<R2::Image>& runs, const SceneImages& images,
                          const std::vector<double>& losses = {});

Comparison Compare(const Submission& student, const SceneImages& images);
/// Compares a student's image with the expected one.
///   expected   SceneImages::Cells of an image that replaces the reference
Comparison Compare(const Submission& student, const R2::Image& expected, const SceneImages& images);

}  // namespace ray::grade

#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "grader/SceneImages.h"

namespace ray::grade {

/// The verdict on a student who made known mistakes. The images are our own with the mistakes, with the camera slightly
/// shifted, in 8 bits.
struct MatrixRow {
  enum class Outcome {
    by_name,     // the mistakes are named
    same_image,  // a cause that makes the same images is named
    empty,       // all images that differ are black or of one color, which a rule reports
    wrong,       // another cause is named
    silent,      // no cause is named
    invisible    // no scene shows it
  };

  std::string mistakes;  // their names
  std::string shown_by;  // the scenes that they change, with the percentage of pixels
  double percent = 0;    // of the pixels that they change in the scene that shows them best
  Outcome outcome = Outcome::invisible;
  std::string named;

  std::string Text() const;
};

struct MatrixCounts {
  std::array<int, 6> of{};  // by outcome
  std::vector<MatrixRow> rows;

  int Count(MatrixRow::Outcome outcome) const { return of[static_cast<std::size_t>(outcome)]; }
};

/// Tries every mistake of the table, and `pairs` pairs of them that a seed selects.
MatrixCounts TryMistakes(std::vector<std::unique_ptr<SceneImages>>& scenes, const Suite& suite, int pairs);

}  // namespace ray::grade

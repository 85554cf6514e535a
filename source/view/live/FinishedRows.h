#pragma once

#include <span>
#include <vector>

#include "source/film/Film.h"

namespace ray {

/// The rows of an image that will not change any more, from the bottom, as blocks of its film get all their samples.
class FinishedRows {
 public:
  /// `film`: an empty one of the image.
  explicit FinishedRows(const Film& film);

  /// These blocks have them now. Returns the rows that are final since then, of the film's region; empty for none.
  PixelRectangle Add(std::span<const int> blocks);

 private:
  int columns_;
  PixelRectangle region_;
  std::vector<int> missing_;  // blocks of each row of them
  std::vector<int> final_;    // where the rows of the image end that are final once all blocks are there up to this row
  std::size_t whole_ = 0;     // rows of blocks, from the bottom
  int top_;                   // of the rows that are final
};

}  // namespace ray

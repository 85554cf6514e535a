#pragma once

#include <cstddef>
#include <vector>

#include "source/parse/Text.h"
#include "source/parse/document/Value.h"

namespace ray {

/// Lines and columns of a text by offset. Some are noted ahead, so that asking costs a walk over a few thousand bytes
/// at most, even in a file of a single line.
class TextPlaces {
 public:
  /// `text` must outlive this and the tokens.
  explicit TextPlaces(const Text& text);

  Token At(const Extent& extent) const;

 private:
  struct Place {
    std::size_t line = 1, column = 1;
  };
  static constexpr std::size_t stride = 4096;  // bytes from one noted place to the next

  void Step(Place& place, std::size_t offset) const;

  const Text& text_;
  std::vector<Place> noted_;
};

}  // namespace ray

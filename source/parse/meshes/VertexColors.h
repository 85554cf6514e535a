#pragma once

#include <array>
#include <optional>
#include <vector>

#include "source/parse/meshes/Tally.h"

namespace ray {

/// Collects the colors of vertices, of which some may have none: those are white. Files say channels from 0 to 1, or
/// from 0 to 255 without a word about it.
class VertexColors {
 public:
  /// The color of the next vertex; channels that are not usable, or negative, are counted, and make it white.
  ///   place   index of the vertex
  void Add(std::size_t place, const std::array<double, 3>& channels, const Token& where);

  /// One for each of the vertices, or nothing where none has one.
  std::vector<std::array<float, 3>> Take(std::size_t vertices);
  /// Whether the channels were of 0 to 255.
  bool WereBytes() const { return greatest_ > 1; }
  void Warn(const Text& file, Report& report) const;

 private:
  std::vector<std::array<float, 3>> colors_;
  double greatest_ = 0;
  Tally absent_;
};

}  // namespace ray

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "source/parse/meshes/MeshWords.h"

namespace ray {

/// Collects the colors of vertices, of which some may have none: those are white. Files say channels from 0 to 1, or
/// from 0 to 255 without a word about it. The author's viewer shows channels above 1 as 1, and so does Take.
class VertexColors {
 public:
  /// Sets the color of a vertex. Channels that are not usable, or negative, are counted, and make it white.
  ///   place   index of the vertex
  void Add(std::size_t place, const std::array<double, 3>& channels, const Token& where);

  /// One for each of the vertices, or nothing where none has one.
  std::vector<std::array<float, 3>> Take(std::size_t vertices);
  /// Returns true if there is no color yet.
  bool IsEmpty() const { return colors_.empty(); }
  /// Returns true if the channels were of 0 to 255; known once they are taken.
  bool WereBytes() const { return were_bytes_; }
  /// Call it after Take.
  void Warn(const Text& file, Report& report) const;

 private:
  std::vector<std::array<float, 3>> colors_;
  double greatest_ = 0;
  bool were_bytes_ = false;
  Tally absent_;
};

}  // namespace ray

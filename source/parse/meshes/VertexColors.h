#pragma once

#include <array>
#include <vector>

#include "source/parse/meshes/MeshWords.h"

namespace ray {

/// A collector of vertex colors; vertices without one are white. Files use channels from 0 to 1, or from 0 to 255,
/// without stating which. The course author's viewer clamps channels above 1, and so does Take.
class VertexColors {
 public:
  /// Sets the color of a vertex. Invalid or negative channels are counted, and make it white.
  ///   place   index of the vertex
  void Add(std::size_t place, const std::array<double, 3>& channels, const Token& where);

  /// Returns one color per vertex, or an empty vector if no vertex has one.
  std::vector<std::array<float, 3>> Take(std::size_t vertices);
  /// Returns true if no color was added yet.
  bool IsEmpty() const { return colors_.empty(); }
  /// Returns true if the channels were in 0 to 255; valid after Take.
  bool WereBytes() const { return were_bytes_; }
  /// Adds the warnings; called after Take.
  void Warn(const Text& file, Report& report) const;

 private:
  std::vector<std::array<float, 3>> colors_;
  double greatest_ = 0;
  bool were_bytes_ = false;
  Tally absent_;
};

}  // namespace ray

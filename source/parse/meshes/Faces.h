#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "R1/HugePages.h"
#include "R3/Mesh.h"
#include "R3/MeshData.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/parse/meshes/MeshWords.h"

namespace ray {

/// A vertex that a file lacks: the crossing of two sides of a face, at a share of the way from one vertex to another.
struct AddedVertex {
  std::uint32_t from, to;
  double share;
};

/// A converter from the faces of a file to the triangles of a mesh. For text files, it records the line of each.
class Faces {
 public:
  explicit Faces(R3::MeshData& mesh) : mesh_(mesh) {}

  /// Reserves memory for the faces that a file declares, limited by the triangles that `bytes_left` bytes may contain.
  void Reserve(std::size_t faces, std::size_t bytes_left) {
    constexpr std::size_t least_bytes = 4;  // per triangle: the number of its corners, and three indices
    R1::ReserveOnHugePages(mesh_.triangles, std::min(faces, bytes_left / least_bytes));
  }
  /// Adds a face whose corners are at `places`, indices into the mesh's positions; the triangles are made of the
  /// corresponding `names`. Returns the fault of the face, or null. Faces with fewer than 3 corners, which occur
  /// in real files, are counted and skipped.
  ///   where   a word of the face; without a line in a binary file
  const char* Add(std::span<const std::uint32_t> places, std::span<const std::uint32_t> names, const Token& where);
  const char* Add(std::span<const std::uint32_t> places, const Token& where) { return Add(places, places, where); }

  /// Returns the vertices that are still to be added. Code that renames the mesh's vertices must rename theirs too.
  std::vector<AddedVertex>& Added() { return added_; }
  /// Adds them; called after all others were added.
  void AddVertices();

  /// Warns about faces that could not be used unchanged.
  void Warn(const Text& file, Report& report) const;

 private:
  /// A corner of a triangle that is an added vertex.
  struct Use {
    std::size_t triangle, corner, added;
  };

  void AddTriangle(const std::array<std::uint32_t, 3>& names, const Token& where);

  R3::MeshData& mesh_;
  std::vector<AddedVertex> added_;
  std::vector<Use> uses_;
  Tally too_small_;
  std::size_t fanned_ = 0;
  std::vector<R3::Point> polygon_;
};

/// A corner of a face in formats whose faces index positions, texture coordinates and normals separately.
struct Corner {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t place, uv = none, normal = none;

  friend auto operator<=>(const Corner&, const Corner&) = default;
};

/// Converts triangles of corners to triangles of vertices. A vertex of a mesh has one normal and one pair of texture
/// coordinates; a position with several of them in the file becomes several vertices. Takes n log n time for n corners.
///   mesh      positions, and colors of positions, as in the file; triangles that index `corners`
///   added     vertices between those of corners, which are renamed like them
///   uvs       the targets of the corners' uv and normal indices, likewise `normals`; empty if the mesh has none
void MakeVertices(R3::MeshData& mesh, std::span<const Corner> corners, std::span<AddedVertex> added,
                  std::span<const R2::Point> uvs, std::span<const R3::Normal> normals);

}  // namespace ray

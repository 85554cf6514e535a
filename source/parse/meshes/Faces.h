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

/// A vertex that a file lacks: where two sides of a face cross, at a share of the way from one vertex to another.
struct AddedVertex {
  std::uint32_t from, to;
  double share;
};

/// Turns the faces of a file into the triangles of a mesh, and notes the line of each where the file is text.
class Faces {
 public:
  explicit Faces(R3::MeshData& mesh) : mesh_(mesh) {}

  /// Makes room for faces that a file declares, as far as `bytes_left` of it may hold triangles.
  void Reserve(std::size_t faces, std::size_t bytes_left) {
    constexpr std::size_t least_bytes = 4;  // of a triangle: the number of its corners, and three indices
    R1::ReserveOnHugePages(mesh_.triangles, std::min(faces, bytes_left / least_bytes));
  }
  /// Adds a face whose corners are at `places`, indices into the mesh's positions; the triangles are made of the
  /// `names` that go with them. Gives what is wrong with the face, or null. A face of fewer than 3 corners, which
  /// real files do hold, is counted and left out.
  ///   where   a word of the face; of no line in a binary file
  const char* Add(std::span<const std::uint32_t> places, std::span<const std::uint32_t> names, const Token& where);
  const char* Add(std::span<const std::uint32_t> places, const Token& where) { return Add(places, places, where); }

  /// The vertices that are still to be added. Whoever renames those of the mesh renames theirs.
  std::vector<AddedVertex>& Added() { return added_; }
  /// Adds them, when all others are there.
  void AddVertices();

  /// Warns of what could not be taken as it stands.
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

/// A corner of a face in formats whose faces index places, texture coordinates and normals one by one.
struct Corner {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t place, uv = none, normal = none;

  friend auto operator<=>(const Corner&, const Corner&) = default;
};

/// Turns triangles of corners into triangles of vertices. A vertex of a mesh has one normal and one pair of texture
/// coordinates; where a file gives a place several of them, it becomes several vertices. Takes n log n time for n
/// corners.
///   mesh      positions, and colors of places, as the file has them; triangles that index `corners`
///   added     vertices between those of corners, which are renamed like them
///   uvs       what the corners' uv and normal index, likewise `normals`; where they are empty the mesh has none
void MakeVertices(R3::MeshData& mesh, std::span<const Corner> corners, std::span<AddedVertex> added,
                  std::span<const R2::Point> uvs, std::span<const R3::Normal> normals);

}  // namespace ray

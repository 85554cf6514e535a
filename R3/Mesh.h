#pragma once

#include <array>
#include <memory>
#include <string>

#include "R2/Color.h"
#include "R3/MeshData.h"
#include "R3/Shape.h"
#include "R3/Transform.h"

namespace R3 {

/// A triangle mesh, shaded flat as the course does unless asked to be smooth.
/// Triangles without area (decided by an exactly vanishing cross product of their edges) are dropped at construction
/// and counted: nothing could say which way they face. In a smooth mesh the vertex normals decide which side of a
/// triangle is its front: those that TrianglesAgainstNormals finds are turned around at construction, so that shading,
/// refraction, maps, emission and the viewer agree about the side.
class Mesh : public Shape {
 public:
  /// Asserts what MeshData demands. `smooth` uses the normals of the data; without any the mesh is flat.
  ///   file   the name of the file that the data was read from, if it holds nothing else; otherwise empty
  explicit Mesh(MeshData data, bool smooth = false, std::string file = {});

  int Elements() const override { return static_cast<int>(data_.triangles.size()); }
  Box Bounds(int element) const override;
  std::optional<Hit> Intersect(const Ray& ray, int element) const override;
  Intersection At(const Ray& ray, const Hit& hit, int element) const override;
  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int element) const override;
  /// Its own triangles. If they are few they are cut into equal smaller ones, so that what is evaluated only at
  /// vertices, such as a texture or the light of a lamp nearby, is seen between them too.
  MeshData Tessellate(int fineness) const override;
  Form FormOfElements() const override { return Form::flat; }
  bool IsSolid() const override { return false; }  // a surface, closed or not
  bool HasTextureCoordinates() const override { return !data_.uvs.empty(); }
  bool IsDegenerate() const override { return data_.triangles.empty(); }
  /// The recipe of a single triangle with the texture coordinates of a `tri`.
  std::optional<Recipe> MadeFrom() const override;

  /// A copy with texture coordinates, for a mesh that has none. They are the position, projected along the axis that a
  /// triangle faces most:
  ///
  ///     -x: (z, y)   +x: (-z, y)   -y: (x, z)   +y: (x, -z)   -z: (-x, y)   +z: (x, y)
  ///
  /// Images are never mirrored, and they are upright on fronts that face sideways. All triangles of a polygon share one
  /// axis. If two axes are equally near, but for rounding, y comes before z and z before x. Vertices where the axis
  /// changes are copied.
  std::unique_ptr<const Mesh> Projected() const;

  /// The mesh with every corner moved by `move`, rounded once. Fronts stay fronts: a mirror swaps the second and third
  /// corner of triangles, which keep their numbers. Null when something would be lost: a corner would not be finite, or
  /// a triangle would be left without area.
  std::unique_ptr<const Mesh> Moved(const Transform& move) const;

  /// The blend of the corners' colors at a hit; white where the mesh has none.
  R2::Color ColorAt(const Hit& hit, int element) const;

  /// Whether the triangles bound a volume, their fronts outward; see Winding.h.
  bool IsClosed() const;

  /// The data given, without its line numbers, and with triangles turned to agree with the normals; these are zero or,
  /// unless moved, of unit length.
  const MeshData& Data() const { return data_; }
  bool IsSmooth() const { return smooth_; }
  /// Empty unless the mesh was read from a file of its own and has not been moved.
  const std::string& File() const { return file_; }
  /// How many triangles had no area.
  int DroppedTriangles() const { return dropped_; }
  /// How many triangles were turned around, and the line of the file that the first of them is on; 0: unknown.
  int TurnedTriangles() const { return turned_; }
  std::uint32_t FirstTurnedLine() const { return first_turned_line_; }
  std::array<Point, 3> Corners(int element) const {
    const auto& t = data_.triangles[static_cast<std::size_t>(element)];
    return {data_.positions[t[0]], data_.positions[t[1]], data_.positions[t[2]]};
  }
  /// Pointers to the corners, which live as long as the mesh.
  std::array<const Point*, 3> CornersInPlace(int element) const {
    const auto& t = data_.triangles[static_cast<std::size_t>(element)];
    return {&data_.positions[t[0]], &data_.positions[t[1]], &data_.positions[t[2]]};
  }

 private:
  Mesh() = default;
  void DropTrianglesWithoutArea();
  void TurnToNormals();
  /// Appends to `mesh` a vertex that blends three corners' positions, normals, texture coordinates and colors.
  void AppendBlend(const std::array<std::uint32_t, 3>& corners, const std::array<double, 3>& weights,
                   MeshData& mesh) const;

  MeshData data_;
  bool smooth_ = false;
  std::string file_;
  int dropped_ = 0, turned_ = 0;
  std::uint32_t first_turned_line_ = 0;
};

/// The texture coordinates that the corners of a `tri` have.
std::vector<R2::Point> TriUvs();

}  // namespace R3

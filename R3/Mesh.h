#pragma once

#include <array>
#include <memory>
#include <string>

#include "R2/Color.h"
#include "R3/MeshData.h"
#include "R3/Shape.h"
#include "R3/Transform.h"

namespace R3 {

/// A triangle mesh, shaded flat as in the course unless smooth shading is requested. Triangles without area (decided by
/// an exactly vanishing cross product of their edges) are dropped at construction and counted, since they have no
/// orientation. In a smooth mesh the vertex normals decide which side of a triangle is its front: triangles found by
/// TrianglesAgainstNormals are flipped at construction, so that shading, refraction, maps, emission and the viewer
/// agree about the side.
class Mesh : public Shape {
 public:
  /// Makes a mesh. Asserts the requirements of MeshData. `smooth` uses the normals of the data; without any the mesh is
  /// flat.
  ///   file   the name of the file that the data were read from, if it contains nothing else; otherwise empty
  explicit Mesh(MeshData data, bool smooth = false, std::string file = {});

  int Elements() const override { return static_cast<int>(data_.triangles.size()); }
  Box Bounds(int element) const override;
  std::optional<Hit> Intersect(const Ray& ray, int element) const override;
  Intersection At(const Ray& ray, const Hit& hit, int element) const override;
  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int element) const override;
  /// Returns the mesh's own triangles. If there are few, they are subdivided evenly, so that effects evaluated only at
  /// vertices, such as a texture or the light of a nearby lamp, are visible between them too.
  MeshData Tessellate(int fineness) const override;
  Form FormOfElements() const override { return Form::flat; }
  bool IsSolid() const override { return false; }  // a surface, closed or not
  bool HasTextureCoordinates() const override { return !data_.uvs.empty(); }
  bool IsDegenerate() const override { return data_.triangles.empty(); }
  /// Returns the recipe of a single triangle with the texture coordinates of a `tri`.
  std::optional<Recipe> MadeFrom() const override;

  /// Returns a copy with texture coordinates, for a mesh that has none. They are the position, projected along the axis
  /// that a triangle faces most:
  ///
  ///     -x: (z, y)   +x: (-z, y)   -y: (x, z)   +y: (x, -z)   -z: (-x, y)   +z: (x, y)
  ///
  /// Images are never mirrored, and they are upright on fronts that face sideways. All triangles of a polygon share one
  /// axis. If two axes are equally near up to rounding, y comes before z and z before x. Vertices where the axis
  /// changes are duplicated.
  std::unique_ptr<const Mesh> Projected() const;

  /// Returns the mesh with every corner transformed by `move`, rounded once. Fronts stay fronts: a mirroring swaps the
  /// second and third corner of triangles, which keep their numbers. Null if something would be lost: a corner would
  /// not be finite, or a triangle would have no area.
  std::unique_ptr<const Mesh> Moved(const Transform& move) const;

  /// Returns the interpolated color at a hit; white if the mesh has no colors.
  R2::Color ColorAt(const Hit& hit, int element) const;

  /// Returns true if the triangles bound a volume with their fronts outward; see Winding.h.
  bool IsClosed() const;

  /// Returns the given data without line numbers, with triangles flipped to agree with the normals. Normals are zero
  /// or, unless moved, of unit length.
  const MeshData& Data() const { return data_; }
  bool IsSmooth() const { return smooth_; }
  /// Returns the file's name; empty unless the mesh was read from its own file and has not been moved.
  const std::string& File() const { return file_; }
  /// Returns the number of triangles without area.
  int DroppedTriangles() const { return dropped_; }
  /// Returns the number of flipped triangles.
  int TurnedTriangles() const { return turned_; }
  /// Returns the line in the file of the first flipped triangle; 0 if unknown.
  std::uint32_t FirstTurnedLine() const { return first_turned_line_; }
  std::array<Point, 3> Corners(int element) const {
    const auto& t = data_.triangles[static_cast<std::size_t>(element)];
    return {data_.positions[t[0]], data_.positions[t[1]], data_.positions[t[2]]};
  }
  /// Returns pointers to the corners, which live as long as the mesh.
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

/// Returns the texture coordinates of the corners of a `tri`.
std::vector<R2::Point> TriUvs();

}  // namespace R3

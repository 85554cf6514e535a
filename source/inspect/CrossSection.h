#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "R2/Point.h"
#include "R2/Vector.h"
#include "source/accelerate/Accelerator.h"
#include "source/draw/Drawing.h"
#include "source/scene/Camera.h"

/// The cross section of a scene, drawn in its plane.
namespace ray {

/// The plane of a cut: two axes of the world, or all camera rays of one row of the image.
enum class SlicePlane { xz, yz, xy, camera_row };

/// The visible part of a plane: a square about `center` whose sides are along u and v.
struct Slice {
  R3::Point center;
  R3::Vector u{1, 0, 0}, v{0, 1, 0};  // unit, perpendicular: to the right and upward
  double extent = 1;                  // half a side, > 0

  /// The orthogonal projection of p onto the plane.
  R2::Point Project(const R3::Point& p) const { return {Dot(p - center, u), Dot(p - center, v)}; }
  R2::Vector Project(const R3::Vector& d) const { return {Dot(d, u), Dot(d, v)}; }
  R3::Point InWorld(const R2::Point& p) const { return center + p.x * u + p.y * v; }
};

/// The plane with those two axes through a point (`plane` is not camera_row), seen so that its first axis runs to the
/// right and its second upward, except yz, where y runs upward. The square is around the middle of the scene and holds
/// all of its cut.
Slice AxisSlice(SlicePlane plane, const R3::Point& through, const R3::Box& scene);
/// The plane through the eye, camera.right and the directions of view through row `y` of an image (in pixels from its
/// lower edge; y + 0.5 is the middle of row y): it holds every ray through that row. The direction of view is up. The
/// square holds all of the scene's cut; the eye may lie outside it.
Slice CameraSlice(const Camera& camera, double y, int width, int height, const R3::Box& scene);

/// A crossing of an instance's surface with a line of the grid by which a slice is searched.
struct Crossing {
  R2::Point on_slice;  // in its coordinates
  R3::Point position;  // in the world; within its Intersection's error of the surface
  R2::Vector normal;   // outward, projected onto the plane: shorter than 1 unless the surface is perpendicular to it
  std::uint32_t instance = 0;
  bool enters = false;  // going along the grid line in the direction of u or v
};

/// The connection of two crossings of an instance within one cell of the grid. Straight; or over a corner, where the
/// tangents at both ends meet in the cell at an angle.
struct CutPiece {
  std::uint32_t from = 0, to = 0;  // indices of crossings
  std::optional<R2::Point> corner;
};

struct SceneCut {
  Slice slice;
  std::vector<Crossing> crossings;
  std::vector<CutPiece> pieces;
  int lines_given_up = 0;  // grid lines with more than most_crossings, of which the others are missing
};

inline constexpr int most_crossings = 4096;  // of one grid line

/// All surfaces that the slice cuts, found by asking the shapes themselves: by rays in the plane, `lines` (at least 2)
/// of them along u and as many along v, each from crossing to crossing.
///
/// Crossings are as exact as any hit. Pieces are not: they assume that a surface continues from one crossing to the
/// next, which is wrong where details are smaller than a cell (2 extent / lines). Details between neighboring grid
/// lines in both directions are not found, and only one of coinciding surfaces is. A surface in the plane itself is
/// found as its shape intersects rays in the plane: a box by its outline, a triangle not at all.
SceneCut CutOf(const World& world, const Accelerator& accelerator, const Slice& slice, int lines);

}  // namespace ray

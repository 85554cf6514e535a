#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R2/Point.h"
#include "R3/Vector.h"

/// Importance sampling by inversion: maps from the unit square to disks, triangles and directions, and their pdfs. They
/// turn uniform random numbers into points on lights and directions to follow.
///
/// Every map takes a finite `u` in [0, 1]^2 and preserves neighborhoods, so that strata of the square remain strata of
/// the target. Directions are about +z; FromTangents turns them to be about another vector. They are unit within 1e-14,
/// finite for every u. Pdfs are per solid angle and belong to the map of the same name.
namespace R3 {

/// Two unit vectors perpendicular to a third and to each other.
struct Tangents {
  Vector first, second;
};

/// Returns tangents of any unit vector, within 1e-15. They jump where n.z changes its sign and nowhere else.
/// Source: Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin, Building an orthonormal basis, revisited (2017).
inline Tangents TangentsOf(const Vector& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// Returns `local`, given about +z, rotated to be about the unit vector `about`: +z maps to `about`, x and y to its
/// tangents. Lengths are kept within 1e-15 relative.
inline Vector FromTangents(const Vector& local, const Vector& about) {
  const Tangents tangents = TangentsOf(about);
  return local.x * tangents.first + local.y * tangents.second + local.z * about;
}

/// Maps the unit square to the unit disk, preserving shares of area; within 1e-15 of the disk.
/// Source: Shirley, Chiu, A low distortion map between disk and square (1997).
inline R2::Point SampleUniformDiskConcentric(const R2::Point& square) {
  const double a = 2 * square.x - 1, b = 2 * square.y - 1;
  const bool is_wide = std::abs(a) > std::abs(b);
  const double radius = is_wide ? a : b, other = is_wide ? b : a;
  const auto [sine, cosine] = R1::SinCosEighth(other / (radius == 0 ? 1 : radius) / 8);
  return {radius * (is_wide ? cosine : sine), radius * (is_wide ? sine : cosine)};
}

/// Returns barycentric coordinates in a triangle, uniform by area: each >= 0, their sum within 2^-52 of 1.
/// Source: Turk, Generating random points in triangles, Graphics Gems (1990), first method.
inline std::array<double, 3> SampleUniformTriangle(const R2::Point& u) {
  const double root = std::sqrt(u.x);
  return {1 - root, root * (1 - u.y), root * u.y};
}

/// Samples a direction above the plane with a pdf proportional to its cosine with +z: a point of the disk lifted onto
/// the hemisphere. z may be 0, where the pdf is 0 too.
/// Source: Malley's method, in Pharr, Jakob, Humphreys, Physically Based Rendering (2023), section A.5.3.
inline Vector SampleCosineHemisphere(const R2::Point& u) {
  const R2::Point p = SampleUniformDiskConcentric(u);
  return {p.x, p.y, std::sqrt(std::max(0.0, 1 - p.x * p.x - p.y * p.y))};
}
/// Returns cosine / pi; 0 below the plane.
inline double CosineHemispherePdf(double cosine) { return std::max(0.0, cosine) / std::numbers::pi; }

/// Returns the direction with the given sine and cosine from +z and turns from +x towards +y.
inline Vector FromPolar(double sine, double cosine, double turns) {
  const auto [y, x] = R1::SinCosTurnsInRange(turns);
  return {sine * x, sine * y, cosine};
}

/// Samples a direction above the plane with a pdf proportional to the n-th power of its cosine with +z: Phong's lobe.
///   n        >= 0 and finite; tested from 0, which is uniform over the hemisphere, to 1e6
///   source   Lafortune, Willems, Using the modified Phong reflectance model for physically based rendering (1994),
///            eq. 10; through logarithms, since for large n the cosine alone would round the angle away
Vector SamplePhongLobe(const R2::Point& u, double n);
/// Returns (n + 1) / (2 pi) cosine^n; 0 below the plane. Rounding of the cosine causes a relative error of n 2^-53.
double PhongLobePdf(double cosine, double n);

/// Samples a direction uniformly.
/// Source: Archimedes' theorem that the area of a sphere's zone is proportional to its height.
Vector SampleUniformSphere(const R2::Point& u);
inline constexpr double uniform_sphere_pdf = 1 / (4 * std::numbers::pi);

/// Samples a direction in the cone about +z uniformly.
///   one_minus_cosine   of the cone's half angle, in [0, 2]: 1 is the hemisphere, 2 the sphere, 0 only +z. Not the
///                      cosine, because that of a narrow cone rounds to 1
///   accuracy           the angle from +z within 1e-15 relative, however narrow the cone
///   source             Shirley, Chiu, A low distortion map between disk and square (1997), the disk lifted by
///                      Archimedes'
///                      theorem, as above. A shadow's edge cuts fewer of its strata than of those between circles and
///                      radii: direct light from a ball has .95 of the error
inline Vector SampleUniformCone(const R2::Point& u, double one_minus_cosine) {
  const R2::Point p = SampleUniformDiskConcentric(u);
  const double distance = std::max(std::abs(2 * u.x - 1), std::abs(2 * u.y - 1));  // of p from the middle
  const double height = distance * distance * one_minus_cosine;                    // down from the top of the sphere
  const double width = std::sqrt(one_minus_cosine * (2 - height));
  return {width * p.x, width * p.y, 1 - height};
}
/// Returns 1 over the cone's solid angle; infinite for the cone that is only +z.
inline double UniformConePdf(double one_minus_cosine) { return 1 / (2 * std::numbers::pi * one_minus_cosine); }

}  // namespace R3

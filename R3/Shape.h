#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "R2/Point.h"
#include "R3/Box.h"
#include "R3/Crossings.h"
#include "R3/Hit.h"
#include "R3/Intersection.h"
#include "R3/MeshData.h"
#include "R3/Ray.h"
#include "R3/SphereData.h"
#include "R3/SurfaceSamples.h"
#include "R3/UvTangents.h"

namespace R3 {

/// A random point on a surface, as seen from another point.
struct SurfaceSample {
  Intersection at;  // without texture coordinates
  double pdf = 0;   // per solid angle, > 0; may be infinite
};

/// Returns the pdf per solid angle of a point drawn uniformly by area: the squared distance over the projected area.
///   towards, t   the point is t lengths of `towards` away
///   normal       of the surface there, unit, on either side
///   returns      0 if the area is seen edge-on
inline double SolidAnglePdf(const Normal& normal, const Vector& towards, double t, double area) {
  const double distance = t * Length(towards);
  const double cosine = std::abs(Dot(normal, towards)) / Length(towards);
  return cosine > 0 && area > 0 ? distance * distance / (cosine * area) : 0;
}

/// The line of a scene file that recreates a shape or a light: the name of its kind, and the kind's arguments in file
/// order. The copy is bit-identical.
struct Recipe {
  const char* kind;
  std::vector<double> arguments;
  std::string text{};  // precedes the arguments, as a formula
};

/// A rotationally symmetric bound of a shape about y. In coordinates from -1 to 1 within the shape's bounding box, the
/// shape lies inside
///
///     x^2 + z^2 + bulge y^2 <= (radius + taper y)^2.
///
/// The default contains the whole box.
struct Profile {
  double radius = 2, taper = 0;  // radius >= |taper|
  double bulge = 0;              // 0 or 1

  static constexpr Profile Ball() { return {1, 0, 1}; }
  static constexpr Profile Upright() { return {1, 0, 0}; }  // a cylinder
  static constexpr Profile Pointed() { return {0.5, -0.5, 0}; }
};

/// The form of a surface with regard to rays that start on it.
enum class Form {
  flat,    // planar: no such ray meets it again
  convex,  // bounds a convex solid: no ray that heads outward meets it again
  other
};

/// An object that rays can hit, made of one or more elements (a mesh has one per triangle).
class Shape {
 public:
  virtual ~Shape() = default;

  virtual int Elements() const { return 1; }

  /// Returns a box that contains the element.
  virtual Box Bounds(int element) const = 0;

  /// Returns the nearest crossing of `ray` with the element.
  ///   ray       any direction length; t counts in lengths of ray.direction
  ///   returns   t strictly inside (ray.t_min, ray.t_max); std::nullopt on a miss, or if an input is NaN. Otherwise t
  ///             does
  ///             not depend on t_min and t_max: narrowing them never changes a crossing, only drops it.
  ///   accuracy  ray.At(t) lies within 32 u (D + size) of the surface, D the distance from ray.origin to it
  virtual std::optional<Hit> Intersect(const Ray& ray, int element) const = 0;

  /// Returns the first crossings with the element, bit-identical to those that repeated calls of Intersect return with
  /// the last t as t_min. Shapes that find several at once override it.
  virtual Crossings CrossingsAlong(const Ray& ray, int element) const;

  /// Returns the surface at a hit that Intersect returned for the same ray and element.
  virtual Intersection At(const Ray& ray, const Hit& hit, int element) const = 0;
  /// Returns the same as At without texture coordinates and ends of v, in less time.
  virtual Intersection PlaceAt(const Ray& ray, const Hit& hit, int element) const { return At(ray, hit, element); }

  /// Returns how the texture coordinates of At change along the surface; called only for bump and normal maps. Tangents
  /// are 0 or parallel if undefined, as at the pole of a sphere; maps have no effect there. The default finds them by
  /// rays, which is accurate if the shape is about as long as it is wide; closed forms are accurate for any shape.
  virtual UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int element) const;

  /// Returns triangles near the surface, for display only, never for tracing: corners on the surface, fronts outward;
  /// those of a solid are closed if coincident corners are merged. Has normals if the surface is smooth or has separate
  /// faces; no normals if each triangle is flat. Empty for a degenerate shape. The default finds them by rays.
  ///   fineness  >= 3: the number of pieces of a full turn, or about four times those of a straight side. The result
  ///             has
  ///             about its square of triangles or fewer, but at least 12, some 600 if found by rays, and for a mesh at
  ///             least its own
  virtual MeshData Tessellate(int fineness) const;

  /// Returns true if it lies in a box. An unbounded shape has empty Bounds, one element, and a Tessellate of some piece
  /// of it.
  virtual bool IsBounded() const { return true; }

  /// Returns true if points on the surface can be sampled, so that the shape can be a lamp. Such a shape overrides
  /// SampledArea and DrawPlace, or Sample and Pdf.
  virtual bool CanBeSampled() const { return false; }
  /// Samples a point of the element that faces `from`: each of them with a pdf above 0, including hidden ones.
  ///   u         in [0, 1)^2, uniform
  ///   returns   std::nullopt if no point can be seen
  virtual std::optional<SurfaceSample> Sample(const Point& from, const R2::Point& u, int element) const;
  /// Samples for many points and numbers; results are bit-identical to those of Sample.
  virtual void SampleEach(SurfaceSamples& samples, int element) const;
  /// Returns true if Sample never returns a point that the element itself hides.
  virtual bool DrawsInSight() const { return FormOfElements() == Form::flat; }
  /// Returns the pdf with which Sample draws the point at `way` from `from` with this normal, if `from` sees it.
  virtual double Pdf(const Point& from, const Vector& way, const Normal& normal, int element) const;
  /// Returns the area from which DrawPlace samples; it contains all points of the element that `from` sees.
  virtual double SampledArea(const Point& /*from*/, int /*element*/) const { return 0; }
  /// Samples a point of that area uniformly.
  virtual Intersection DrawPlace(const Point& /*from*/, const R2::Point& /*u*/, int /*element*/) const { return {}; }

  /// Returns the form that each element has.
  virtual Form FormOfElements() const { return Form::other; }
  /// Returns true if the shape bounds a volume that can contain a point.
  virtual bool IsSolid() const { return true; }
  /// Returns true if texture coordinates vary over the surface.
  virtual bool HasTextureCoordinates() const { return true; }
  /// Returns true if nothing can ever hit it (zero radius or height).
  virtual bool IsDegenerate() const { return false; }
  /// Returns a rotationally symmetric bound within its Bounds.
  virtual Profile ProfileInBounds() const { return {}; }
  /// Returns the sphere if the shape is one; IntersectSphere is then equivalent to its Intersect.
  virtual std::optional<SphereData> AsSphere() const { return {}; }
  /// Returns the distinct materials of its parts, in the numbering of its creator; empty if all of it has one material.
  virtual std::vector<int> MaterialsOfParts() const { return {}; }
  /// Returns the material of the part at a hit; negative if the part has none. Called only if MaterialsOfParts is not
  /// empty.
  virtual int MaterialOf(const Hit& /*hit*/) const { return -1; }
  /// Returns the recipe of the shape; std::nullopt if its kind is not in shapes.def.
  virtual std::optional<Recipe> MadeFrom() const { return {}; }
};

/// Returns the box around all elements.
Box Bounds(const Shape& shape);

}  // namespace R3

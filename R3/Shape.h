#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "R2/Point.h"
#include "R3/Box.h"
#include "R3/Crossings.h"
#include "R3/Hit.h"
#include "R3/Intersection.h"
#include "R3/MeshData.h"
#include "R3/Profile.h"
#include "R3/Ray.h"
#include "R3/Recipe.h"
#include "R3/SphereData.h"
#include "R3/SurfaceSamples.h"
#include "R3/UvTangents.h"

namespace R3 {

/// A place on a surface drawn at random, as a point sees it.
struct SurfaceSample {
  Intersection at;  // without texture coordinates
  double pdf = 0;   // per solid angle, > 0; may be infinite
};

/// Per solid angle, of a place drawn uniformly by area: how many times farther than 1 it is, squared, over the area as
/// it looks from there.
///   towards, t   the place is t lengths of `towards` away
///   normal       of the surface there, unit, on either side
///   returns      0 where the area is seen edge on
inline double SolidAnglePdf(const Normal& normal, const Vector& towards, double t, double area) {
  const double distance = t * Length(towards);
  const double cosine = std::abs(Dot(normal, towards)) / Length(towards);
  return cosine > 0 && area > 0 ? distance * distance / (cosine * area) : 0;
}

/// What the form of a surface says of rays that start on it.
enum class Form {
  flat,    // none meets it again: it lies in a plane
  convex,  // none that heads outward meets it again: it bounds a convex solid
  other
};

/// Something a ray can hit, made of one or more elements (a mesh has one per triangle).
class Shape {
 public:
  virtual ~Shape() = default;

  virtual int Elements() const { return 1; }

  /// A box that holds the element.
  virtual Box Bounds(int element) const = 0;

  /// Nearest crossing of `ray` with the element.
  ///   ray       any direction length; t counts in lengths of ray.direction
  ///   returns   t strictly inside (ray.t_min, ray.t_max); nothing on a miss, or if an input is NaN. t does not
  ///             depend on t_min and t_max otherwise: narrowing them never changes a crossing, only drops it.
  ///   accuracy  ray.At(t) lies within 32 u (D + size) of the surface, D the distance from ray.origin to it
  virtual std::optional<Hit> Intersect(const Ray& ray, int element) const = 0;

  /// The first crossings with the element, bit for bit those that Intersect returns when it is asked again with the
  /// last t as t_min. A shape that finds several at once overrides it.
  virtual Crossings CrossingsAlong(const Ray& ray, int element) const;

  /// The surface at a hit that Intersect returned for the same ray and element.
  virtual Intersection At(const Ray& ray, const Hit& hit, int element) const = 0;
  /// Returns what At returns except texture coordinates and ends of v, in less time.
  virtual Intersection PlaceAt(const Ray& ray, const Hit& hit, int element) const { return At(ray, hit, element); }

  /// How the texture coordinates of At run over the surface there; only bump and normal maps ask for it. Tangents are 0
  /// or parallel where there is no telling, as at the pole of a sphere; maps tilt nothing there. Unless a shape says
  /// how, rays find it, which is right where the shape is about as long as it is wide; closed forms are right for any.
  virtual UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int element) const;

  /// Triangles near the surface, to be looked at and never traced: corners on the surface, fronts outward, a solid
  /// closed where corners in the same place are taken for one. Normals where the surface is smooth or has faces of its
  /// own; none where each triangle is flat. Nothing of a degenerate shape. Unless a shape says how, rays find them.
  ///   fineness  >= 3: into how many pieces a full turn is cut, or about four times a straight side. About its square
  ///             of triangles or fewer, but 12 at least, by rays some 600, and a mesh never fewer than its own
  virtual MeshData Tessellate(int fineness) const;

  /// Whether it lies in a box. One that does not has empty Bounds, one element, and a Tessellate of some piece of it.
  virtual bool IsBounded() const { return true; }

  /// Whether places on the surface can be drawn at random, so that the shape can be a lamp. Such a shape has its own
  /// SampledArea and DrawPlace, or Sample and Pdf.
  virtual bool CanBeSampled() const { return false; }
  /// Draws one of the places of the element that `from` sees: each of them with a pdf above 0, hidden ones as well.
  ///   u         in [0, 1)^2, uniform
  ///   returns   nothing where no place can be seen
  virtual std::optional<SurfaceSample> Sample(const Point& from, const R2::Point& u, int element) const;
  /// Sample for many points and numbers, bit for bit.
  virtual void SampleEach(SurfaceSamples& samples, int element) const;
  /// Whether Sample never draws a place that the element itself hides.
  virtual bool DrawsInSight() const { return FormOfElements() == Form::flat; }
  /// The pdf with which Sample draws the place that is `way` away and has this normal, if `from` sees it.
  virtual double Pdf(const Point& from, const Vector& way, const Normal& normal, int element) const;
  /// The area that DrawPlace draws from: all that `from` sees of the element is in it.
  virtual double SampledArea(const Point& /*from*/, int /*element*/) const { return 0; }
  /// A place of that area, uniformly.
  virtual Intersection DrawPlace(const Point& /*from*/, const R2::Point& /*u*/, int /*element*/) const { return {}; }

  /// The form that each element has.
  virtual Form FormOfElements() const { return Form::other; }
  /// Whether the shape bounds a volume that a point can be inside of.
  virtual bool IsSolid() const { return true; }
  /// Whether texture coordinates vary over the surface.
  virtual bool HasTextureCoordinates() const { return true; }
  /// Whether nothing can ever hit it (zero radius or height).
  virtual bool IsDegenerate() const { return false; }
  /// How round it is within its Bounds.
  virtual Profile ProfileInBounds() const { return {}; }
  /// The sphere that the shape is, if it is one: IntersectSphere then is its Intersect.
  virtual std::optional<SphereData> AsSphere() const { return {}; }
  /// The materials of its parts, each once, as its maker numbered them; none if all of it has one material.
  virtual std::vector<int> MaterialsOfParts() const { return {}; }
  /// The material of the part at a hit; negative if the part has none. Called only if MaterialsOfParts names some.
  virtual int MaterialOf(const Hit& /*hit*/) const { return -1; }
  /// Nothing for a shape that is not of a kind of shapes.def.
  virtual std::optional<Recipe> MadeFrom() const { return {}; }
};

/// Box around all elements.
Box Bounds(const Shape& shape);

}  // namespace R3

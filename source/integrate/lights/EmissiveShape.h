#pragma once

#include <optional>
#include <string>
#include <vector>

#include "R3/Shape.h"
#include "source/accelerate/World.h"
#include "source/integrate/shading/Absorption.h"
#include "source/scene/LightBound.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// An emissive shape other than a triangle, as a light. Both sides of its surface shine, including to the inside of a
/// solid. Each place in the graph is a separate light, so one shape in several groups is several lights. The world must
/// outlive it.
class EmissiveShape {
 public:
  EmissiveShape(const World& world, const Instance& instance, int element);

  struct Sample {
    R3::Vector towards;  // ends just before the place, so that a ray of that length stops short of the shape
    double pdf;          // per solid angle, > 0
    R2::Color radiance;  // that arrives from there
  };
  /// Samples a place that is visible from a point at a time in [0, 1).
  ///   random    in [0, 1)^2
  ///   returns   std::nullopt if no place is visible
  std::optional<Sample> SampleTowards(const R3::Point& seen_from, const R2::Point& random, double time) const;
  /// Returns true if the shape has no frame of its own and emits equally to both sides, so that many samples can be
  /// drawn together.
  bool CanSampleEach() const { return instance_->frame == 0 && mean_scale_ == 1 && behind_.IsAsFront(); }
  /// Computes SampleTowards, bit for bit, from each of the points: the ways to the light, the radiance over the pdf,
  /// and the pdfs, 0 if no place is visible. Requires CanSampleEach.
  void SampleEach(LightSamples& samples, LightSamples::Each& pdfs) const;
  /// Returns the pdf with which SampleTowards picks the place that is `towards` away and has this normal.
  double Pdf(const R3::Point& seen_from, const R3::Vector& towards, const R3::Normal& normal, double time) const;

  const R2::Color& Emission() const { return instance_->material->emission; }
  std::int64_t Primitive() const { return instance_->first_primitive + element_; }
  /// Returns true if the shape itself hides no sampled place.
  bool DrawsInSight() const { return instance_->shape->DrawsInSight(); }
  /// Returns R3::Ray::reaching for rays to sampled places.
  std::int64_t Reached() const { return DrawsInSight() ? Primitive() : -1; }
  /// Returns the approximate visible area: half the area of the bounding box, like that of one side of a triangle.
  double ProjectedAreaOfBounds() const;
  std::string Describe() const;
  /// Returns the estimated contribution that light selection uses. Ignores attenuation, as in the course.
  LightBound Bound() const;

 private:
  R3::Point Local(const R3::Point& point, double time) const;
  /// Returns the ratio of a solid angle around a way in the shape's frame to that in the world.
  double SolidAngleRatio(const R3::Vector& way, const R3::Vector& local_way) const;
  /// Implements SampleEach from the places that the shape has drawn.
  void CutOff(const R3::SurfaceSamples& places, LightSamples& samples, LightSamples::Each& pdfs) const;

  const World* world_;
  const Instance* instance_;
  int element_;
  EmissionBehind behind_;
  double size_;        // of the shape in its frame
  double mean_scale_;  // of the frame: the cube root of its determinant, without sign
};

/// Returns all emissive elements that are not triangles and can be sampled.
std::vector<EmissiveShape> EmissiveShapes(const World& world);

/// Returns true if there are other emissive elements, which only scattered rays can find.
bool HasUnsampledEmission(const World& world);

}  // namespace ray

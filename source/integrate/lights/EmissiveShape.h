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

/// A shape other than a triangle whose material emits, as a light: both sides of its surface shine, to the inside of a
/// solid as well. It has a place in the graph of its own, so one shape in several groups is several lights. The world
/// must outlive it.
class EmissiveShape {
 public:
  EmissiveShape(const World& world, const Instance& instance, int element);

  struct Sample {
    R3::Vector towards;  // to just before the place, so that a ray that far stops short of the shape
    double pdf;          // per solid angle, > 0
    R2::Color radiance;  // that arrives from there
  };
  /// One of the places that are seen from a point at a time in [0, 1).
  ///   random    in [0, 1)^2
  ///   returns   nothing where no place can be seen
  std::optional<Sample> SampleTowards(const R3::Point& seen_from, const R2::Point& random, double time) const;
  /// Whether it stands in the world as it is, and sends all its light to either side, so that many samples can be drawn
  /// together.
  bool CanSampleEach() const { return instance_->frame == 0 && mean_scale_ == 1 && behind_.IsAsFront(); }
  /// SampleTowards, bit for bit, from each of the points: the ways to the light, the radiance over the pdf, and the
  /// pdfs, 0 where no place can be seen. Of shapes that can.
  void SampleEach(LightSamples& samples, LightSamples::Each& pdfs) const;
  /// The pdf with which SampleTowards picks the place that is `towards` away and has this normal.
  double Pdf(const R3::Point& seen_from, const R3::Vector& towards, const R3::Normal& normal, double time) const;

  const R2::Color& Emission() const { return instance_->material->emission; }
  std::int64_t Primitive() const { return instance_->first_primitive + element_; }
  /// Whether no place drawn is hidden by the shape itself.
  bool DrawsInSight() const { return instance_->shape->DrawsInSight(); }
  /// R3::Ray::reaching of rays to places drawn.
  std::int64_t Reached() const { return DrawsInSight() ? Primitive() : -1; }
  /// How large it looks, roughly: half the area of the box around it, as of a triangle one of two sides.
  double ProjectedAreaOfBounds() const;
  std::string Describe() const;
  /// What choosing among lights goes by, without fall-off as the course has it.
  LightBound Bound() const;

 private:
  R3::Point Local(const R3::Point& point, double time) const;
  /// How much larger a solid angle around a way looks in the shape's frame than in the world.
  double SolidAngleRatio(const R3::Vector& way, const R3::Vector& local_way) const;
  /// SampleEach of places that the shape has drawn.
  void CutOff(const R3::SurfaceSamples& places, LightSamples& samples, LightSamples::Each& pdfs) const;

  const World* world_;
  const Instance* instance_;
  int element_;
  EmissionBehind behind_;
  double size_;        // of the shape in its frame
  double mean_scale_;  // of the frame: the cube root of its determinant, without sign
};

/// Every element that emits, is no triangle and can be sampled.
std::vector<EmissiveShape> EmissiveShapes(const World& world);

/// Whether something else emits, which scattered rays alone can find.
bool HasUnsampledEmission(const World& world);

}  // namespace ray

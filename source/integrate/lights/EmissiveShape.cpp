#include "source/integrate/lights/EmissiveShape.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"

namespace ray {
namespace {

// The accuracy of Intersect that R3::Shape guarantees, in units of the distance and the size.
constexpr double accuracy_of_hits = 32 * R3::unit_roundoff;

/// Returns the distance from the surface within which rays count as hitting it.
double Nearness(double distance, double size) { return accuracy_of_hits * (distance + size); }

/// Returns the fraction of the way to a place that remains after cutting it off at a height above the surface equal to
/// the error there. Its direction is unchanged, since the pdf belongs to it. 0 or less between places of one surface
/// that only rounding separates.
double ShareOutside(const R3::Vector& way, const R3::Vector& normal, const R3::Vector& error) {
  return 1 - Dot(Abs(normal), error) / std::abs(Dot(normal, way));
}

R3::Vector Column(const R3::Matrix& matrix, std::size_t k) { return {matrix.m[0][k], matrix.m[1][k], matrix.m[2][k]}; }

/// Returns the transposed matrix times a vector.
R3::Vector TransposedTimes(const R3::Matrix& matrix, const R3::Vector& v) {
  return {Dot(Column(matrix, 0), v), Dot(Column(matrix, 1), v), Dot(Column(matrix, 2), v)};
}

double MeanScale(const R3::Matrix& matrix) {
  std::array<R3::Vector, 3> columns{Column(matrix, 0), Column(matrix, 1), Column(matrix, 2)};
  double largest = 0;
  for (const R3::Vector& column : columns) largest = std::max(largest, MaxComponent(Abs(column)));
  for (R3::Vector& column : columns) column = column / largest;  // so that products of three do not overflow
  return largest * R1::Cbrt(std::abs(Dot(columns[0], Cross(columns[1], columns[2]))));
}

bool IsLight(const Instance& instance) { return !instance.mesh && instance.Emits() && !instance.shape->IsDegenerate(); }

}  // namespace

EmissiveShape::EmissiveShape(const World& world, const Instance& instance, int element)
    : world_(&world),
      instance_(&instance),
      element_(element),
      behind_(EmissionBehindOf(instance)),
      size_(instance.shape->Bounds(element).Radius()),
      mean_scale_(MeanScale(world.Frames()[instance.frame].Forward())) {}

R3::Point EmissiveShape::Local(const R3::Point& point, double time) const {
  return world_->Back(instance_->frame, R3::Ray{point, {}, 0, R3::infinity, time}).origin;
}

// A map M takes the unit direction w to M w, and scales solid angles there by |det M| / |M w|^3.
double EmissiveShape::SolidAngleRatio(const R3::Vector& way, const R3::Vector& local_way) const {
  const double ratio = Length(way) / Length(local_way) / mean_scale_;
  return ratio * ratio * ratio;
}

std::optional<EmissiveShape::Sample> EmissiveShape::SampleTowards(const R3::Point& seen_from, const R2::Point& random,
                                                                  double time) const {
  const R3::Point local_from = Local(seen_from, time);
  auto local = instance_->shape->Sample(local_from, random, element_);
  if (!local) return {};
  const double near = Nearness(Length(local->at.position - local_from), size_);
  local->at.error = local->at.error + R3::Vector{near, near, near};
  R3::Intersection at = local->at;
  world_->BringToWorld(instance_->frame, time, at);

  const R3::Vector way = at.position - seen_from;
  const double share = ShareOutside(way, AsVector(at.normal), at.error);
  if (!(share > 0)) return {};
  const double pdf = local->pdf * SolidAngleRatio(way, local->at.position - local_from);
  if (!(pdf > 0)) return {};
  return Sample{share * way, pdf, EmittedBackAlong(way, at.normal, Emission(), behind_)};
}

void EmissiveShape::SampleEach(LightSamples& samples, LightSamples::Each& pdfs) const {
  R3::SurfaceSamples places;
  places.count = samples.count;
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    places.from.Set(i, samples.from[i]), places.random.Set(i, samples.random[i]);
  }
  instance_->shape->SampleEach(places, element_);
  CutOff(places, samples, pdfs);
}

R3_VECTORIZED
void EmissiveShape::CutOff(const R3::SurfaceSamples& places, LightSamples& samples, LightSamples::Each& pdfs) const {
  const R2::Color emission = Emission();
  // Separate arrays, which obviously do not overlap.
  R1::Columns<R3::Vector> ways;
  R1::Columns<R2::Color> colors;
  alignas(64) LightSamples::Each drawn_pdfs;
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const R3::Vector way = places.position[i] - places.from[i], normal = AsVector(places.normal[i]);
    const double near = Nearness(BranchlessLength(way), size_);
    const double share = ShareOutside(way, normal, places.error[i] + R3::Vector{near, near, near});
    const double pdf = share > 0 ? places.pdf[i] : 0;
    const R2::Color color = emission / pdf;
    drawn_pdfs[i] = pdf;
    ways.Set(i, share * way);
    colors.Set(i, {pdf > 0 ? color.r : 0, pdf > 0 ? color.g : 0, pdf > 0 ? color.b : 0});
  }
  for (std::uint32_t i = 0; i < samples.count; ++i) samples.Set(i, ways[i], colors[i]), pdfs[i] = drawn_pdfs[i];
}

double EmissiveShape::Pdf(const R3::Point& seen_from, const R3::Vector& towards, const R3::Normal& normal,
                          double time) const {
  const R3::Transform& world_from_local = world_->Frames()[instance_->frame];
  const R3::Vector way = world_from_local.Inverse() * towards;
  const R3::Normal local_normal = AsNormal(Unit(TransposedTimes(world_from_local.Forward(), AsVector(normal))));
  return instance_->shape->Pdf(Local(seen_from, time), way, local_normal, element_) * SolidAngleRatio(towards, way);
}

double EmissiveShape::ProjectedAreaOfBounds() const {
  const R3::Vector size = instance_->shape->Bounds(element_).Size();
  const R3::Matrix& forward = world_->Frames()[instance_->frame].Forward();
  const R3::Vector a = size.x * Column(forward, 0), b = size.y * Column(forward, 1), c = size.z * Column(forward, 2);
  return Length(Cross(a, b)) + Length(Cross(b, c)) + Length(Cross(c, a));
}

std::string EmissiveShape::Describe() const { return "emissive shape, primitive " + std::to_string(Primitive()); }

LightBound EmissiveShape::Bound() const {
  return BoundWithoutFalloff(world_->InWorld(instance_->frame, instance_->shape->Bounds(element_)),
                             Luminance(Emission()));
}

std::vector<EmissiveShape> EmissiveShapes(const World& world) {
  std::vector<EmissiveShape> shapes;
  for (const Instance& instance : world.Instances())
    if (IsLight(instance) && instance.shape->CanBeSampled())
      for (int i = 0; i < instance.shape->Elements(); ++i) shapes.emplace_back(world, instance, i);
  return shapes;
}

bool HasUnsampledEmission(const World& world) {
  return std::ranges::any_of(
      world.Instances(), [](const Instance& instance) { return IsLight(instance) && !instance.shape->CanBeSampled(); });
}

}  // namespace ray

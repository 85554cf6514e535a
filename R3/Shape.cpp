#include "R3/Shape.h"

#include "R3/ByRays.h"

namespace R3 {

Crossings Shape::CrossingsAlong(const Ray& ray, int element) const {
  Crossings crossings;
  Ray rest = ray;
  while (crossings.count < Crossings::most) {
    const auto hit = Intersect(rest, element);
    if (!hit) return crossings;
    crossings.Add(*hit);
    rest.t_min = hit->t;
  }
  crossings.may_have_more = true;
  return crossings;
}

MeshData Shape::Tessellate(int fineness) const {
  if (IsDegenerate()) return {};
  constexpr int least = 600;
  return TessellateByRays(*this, std::max(least, fineness * fineness));
}

UvTangents Shape::UvTangentsAt(const Ray& ray, const Hit& hit, int element) const {
  return UvTangentsByRays(*this, ray, hit, element);
}

std::optional<SurfaceSample> Shape::Sample(const Point& from, const R2::Point& u, int element) const {
  const double area = SampledArea(from, element);
  if (!(area > 0)) return {};
  const Intersection at = DrawPlace(from, u, element);
  const double pdf = SolidAnglePdf(at.normal, at.position - from, 1, area);
  return pdf > 0 ? std::optional(SurfaceSample{at, pdf}) : std::nullopt;
}

void Shape::SampleEach(SurfaceSamples& samples, int element) const {
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const auto drawn = Sample(samples.from[i], samples.random[i], element);
    if (drawn)
      samples.Set(i, drawn->at.position, drawn->at.error, drawn->at.normal, drawn->pdf);
    else
      samples.Set(i, {}, {}, {}, 0);
  }
}

double Shape::Pdf(const Point& from, const Vector& way, const Normal& normal, int element) const {
  return SolidAnglePdf(normal, way, 1, SampledArea(from, element));
}

Box Bounds(const Shape& shape) {
  Box box;
  for (int i = 0; i < shape.Elements(); ++i) box.Extend(shape.Bounds(i));
  return box;
}

}  // namespace R3

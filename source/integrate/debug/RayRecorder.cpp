#include "source/integrate/debug/RayRecorder.h"

#include <utility>

namespace ray {

int RayRecorder::Begin(const R3::Ray& ray, const PathState& path) {
  RecordedRay begun{.kind = path.kind,
                    .parent = path.record,
                    .depth = static_cast<int>(path.depth),
                    .ray = ray,
                    .throughput = path.throughput};
  ForgetDeparture(begun.ray);
  return Keep(std::move(begun));
}

void RayRecorder::Hits(const ShadingPoint& surface, const R2::Color& contribution) {
  RecordedRay& ray = (*this)[surface.path.record];
  ray.hit = surface.hit;
  ray.at = surface.at;
  ray.contribution = contribution;
}

void RayRecorder::BeginShadow(const ShadingPoint& surface, const R3::Ray& ray, const R2::Color& reflected,
                              std::string towards) {
  const int number = Keep({.kind = RayKind::shadow,
                           .parent = surface.path.record,
                           .depth = static_cast<int>(surface.path.depth),
                           .ray = ray,
                           .throughput = reflected,
                           .towards = std::move(towards)});
  shadows_.push_back(number);
}

void RayRecorder::EndShadow(int number, bool is_occluded, const World& world, const Accelerator& accelerator,
                            Workspace& workspace) {
  RecordedRay& ray = (*this)[number];
  if (is_occluded) {
    ray.hit = accelerator.Intersect(ray.ray, workspace);
    if (ray.hit) ray.at = world.At(ray.ray, *ray.hit);
  } else {
    ray.contribution = ray.throughput;
  }
  ForgetDeparture(ray.ray);
}

int RayRecorder::Keep(RecordedRay ray) {
  if (ray.parent != RecordedRay::none) {
    const RecordedRay& parent = (*this)[ray.parent];
    ray.is_inside = parent.at && Dot(parent.at->normal, ray.ray.direction) < 0;
  }
  rays_.push_back(std::move(ray));
  return static_cast<int>(rays_.size()) - 1;
}

}  // namespace ray

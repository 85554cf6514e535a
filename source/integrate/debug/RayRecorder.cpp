#include "source/integrate/debug/RayRecorder.h"

#include <utility>

namespace ray {

int RayRecorder::Begin(const TracedRay& ray) {
  return Keep({.kind = ray.kind,
               .parent = ray.record,
               .depth = static_cast<int>(ray.depth),
               .ray = ray.ray,
               .weight = ray.weight});
}

void RayRecorder::Hits(const ShadingPoint& surface, const R2::Color& brings) {
  RecordedRay& ray = (*this)[surface.found_by.record];
  ray.hit = surface.hit;
  ray.at = surface.at;
  ray.brings = brings;
}

void RayRecorder::BeginShadow(const ShadingPoint& surface, const R3::Ray& ray, const R2::Color& reflected,
                              std::string towards) {
  const int number = Keep({.kind = RayKind::shadow,
                           .parent = surface.found_by.record,
                           .depth = static_cast<int>(surface.found_by.depth),
                           .ray = ray,
                           .weight = reflected,
                           .towards = std::move(towards)});
  shadows_.push_back(number);
}

void RayRecorder::EndShadow(int number, bool is_occluded, const World& world, const Accelerator& accelerator,
                            Workspace& workspace) {
  RecordedRay& ray = (*this)[number];
  if (!is_occluded) {
    ray.brings = ray.weight;
    return;
  }
  ray.hit = accelerator.Intersect(ray.ray, workspace);
  if (ray.hit) ray.at = world.At(ray.ray, *ray.hit);
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

#include "source/integrate/RayRecorder.h"

#include <utility>

namespace ray {

int RayRecorder::Begin(const TracedRay& ray) {
  return Keep({.kind = ray.kind,
               .parent = ray.record,
               .depth = static_cast<int>(ray.depth),
               .ray = ray.ray,
               .weight = ray.weight});
}

void RayRecorder::Hits(const Surface& surface, const R2::Color& brings) {
  RecordedRay& ray = (*this)[surface.found_by.record];
  ray.hit = surface.hit;
  ray.at = surface.at;
  ray.brings = brings;
}

int RayRecorder::BeginShadow(const Surface& surface, const R3::Ray& ray, const R2::Color& reflected,
                             std::string towards) {
  return Keep({.kind = RayKind::shadow,
               .parent = surface.found_by.record,
               .depth = static_cast<int>(surface.found_by.depth),
               .ray = ray,
               .weight = reflected,
               .towards = std::move(towards)});
}

void RayRecorder::EndShadow(int number, const std::optional<WorldHit>& blocker, const World& world) {
  RecordedRay& ray = (*this)[number];
  ray.hit = blocker;
  if (blocker)
    ray.at = world.At(ray.ray, *blocker);
  else
    ray.brings = ray.weight;
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

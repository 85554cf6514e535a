#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "source/accelerate/AcceleratorSettings.h"
#include "source/accelerate/Workspace.h"
#include "source/accelerate/World.h"

namespace ray {

/// Decides which primitives a ray is tested against; never what a test answers. Every accelerator gives the same
/// hits bit for bit: the nearest t, and among equal t the lowest primitive id.
class Accelerator {
 public:
  virtual ~Accelerator() = default;

  /// Nearest hit in (ray.t_min, ray.t_max).
  std::optional<WorldHit> Intersect(const R3::Ray& ray, Workspace& workspace) const {
    std::optional<WorldHit> hit;
    if (IsRay(ray))
      hit = Nearest(ray, workspace);
    else
      ++workspace.counts.bad_rays;
    if (hit) ++workspace.counts.hits;
    return hit;
  }

  /// Whether anything lies in (ray.t_min, ray.t_max).
  bool IsOccluded(const R3::Ray& ray, Workspace& workspace) const {
    bool is_occluded = false;
    if (IsRay(ray))
      is_occluded = Any(ray, workspace);
    else
      ++workspace.counts.bad_rays;
    if (is_occluded) ++workspace.counts.hits;
    return is_occluded;
  }

  /// The one that does the work: an accelerator that only chose another says which, so that rays need no detour.
  virtual const Accelerator& Worker() const { return *this; }
  /// What was built, in lines for the reader of -explain.
  virtual std::vector<std::string> Explain() const { return {}; }
  /// Of memory, besides the world's own.
  virtual std::size_t Bytes() const { return 0; }

 private:
  /// Finite, and going somewhere; no other ray hits anything.
  static bool IsRay(const R3::Ray& ray) {
    return IsFinite(FromOrigin(ray.origin)) && IsFinite(ray.direction) && ray.direction != R3::Vector{} &&
           ray.t_min < ray.t_max;
  }

  virtual std::optional<WorldHit> Nearest(const R3::Ray& ray, Workspace& workspace) const = 0;
  virtual bool Any(const R3::Ray& ray, Workspace& workspace) const = 0;
};

/// One line of accelerators.def.
struct AcceleratorKind {
  const char* name;
  const char* about;
  std::unique_ptr<const Accelerator> (*make)(const World& world, const AcceleratorSettings& settings);
};

/// Every kind, in the order of accelerators.def.
std::span<const AcceleratorKind* const> AcceleratorKinds();
const AcceleratorKind* FindAcceleratorKind(const std::string& name);

}  // namespace ray

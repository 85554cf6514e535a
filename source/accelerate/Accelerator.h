#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "source/accelerate/AcceleratorSettings.h"
#include "source/accelerate/NearestHit.h"
#include "source/accelerate/Workspace.h"
#include "source/accelerate/World.h"

namespace ray {

/// Decides which primitives a ray is tested against; never what a test answers. Every accelerator gives the same
/// hits bit for bit: the nearest t, and what Contact.h says where surfaces touch.
class Accelerator {
 public:
  /// `world` outlives it.
  explicit Accelerator(const World& world) : world_(world), has_unbounded_(!world.Unbounded().empty()) {}
  virtual ~Accelerator() = default;

  /// Nearest hit in (ray.t_min, ray.t_max).
  std::optional<WorldHit> Intersect(const R3::Ray& ray, Workspace& workspace) const {
    std::optional<WorldHit> hit;
    if (!IsRay(ray)) {
      ++workspace.counts.bad_rays;
      return hit;
    }
    NearestHit nearest(world_, ray, hit);
    Search(ray, nearest, workspace);
    if (hit && hit->is_contested) [[unlikely]]
      *hit = Seen(ray, *hit, workspace);
    workspace.counts.hits += hit.has_value();
    return hit;
  }

  /// Whether anything lies in (ray.t_min, ray.t_max).
  bool IsOccluded(const R3::Ray& ray, Workspace& workspace) const {
    bool is_occluded = false;
    if (IsRay(ray))
      is_occluded = Any(ray, workspace) || (has_unbounded_ && IsBehindUnbounded(ray, workspace));
    else
      ++workspace.counts.bad_rays;
    if (is_occluded) ++workspace.counts.hits;
    return is_occluded;
  }

  /// Intersects each ray of a packet: faster for coherent rays, such as those of neighboring pixels, where an
  /// accelerator can trace packets. Answers go to hits[0], hits[1], ..., or are_occluded.
  void Intersect(std::span<const R3::Ray> rays, std::optional<WorldHit>* hits, Workspace& workspace) const {
    NearestOfEach(rays, hits, workspace);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (has_unbounded_ && IsRay(rays[i])) [[unlikely]]
        OfferUnbounded(rays[i], hits[i], workspace);
      if (!hits[i]) continue;
      if (hits[i]->is_contested) [[unlikely]]
        *hits[i] = Seen(rays[i], *hits[i], workspace);
      ++workspace.counts.hits;
    }
  }
  void IsOccluded(std::span<const R3::Ray> rays, bool* are_occluded, Workspace& workspace) const {
    AnyOfEach(rays, are_occluded, workspace);
    if (!has_unbounded_) return;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (!are_occluded[i] && IsRay(rays[i]) && IsBehindUnbounded(rays[i], workspace))
        are_occluded[i] = true, ++workspace.counts.hits;
  }

  /// Returns the hits that are coincident with one that Intersect found, it included, in the order in which they hide
  /// each other; see CoincidentOf.
  std::vector<WorldHit> Coincident(const R3::Ray& ray, const WorldHit& hit, Workspace& workspace) const;

  std::string kind;                  // a line of accelerators.def; where `auto` was asked for, what it chose
  std::vector<std::string> reasons;  // why `auto` chose it
  /// What was built, in lines for the reader of -explain.
  virtual std::vector<std::string> Explain() const { return {}; }
  /// How many levels of nested boxes it has, for the viewer, and the boxes of one level in the world; level 0 is the
  /// outermost. Of the structure inside a shared mesh only the box around it is there. 0 for one that has no boxes.
  virtual int BoxLevels() const { return 0; }
  virtual std::vector<R3::Box> BoxesAt(int /*level*/) const { return {}; }
  /// Bytes of memory that the structure takes, besides the world's own.
  virtual std::size_t Bytes() const { return 0; }

 protected:
  /// What Nearest finds for each of the rays; nothing for what is none, see IsRay, which is counted.
  virtual void NearestOfEach(std::span<const R3::Ray> rays, std::optional<WorldHit>* hits, Workspace& workspace) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      NearestHit nearest(world_, rays[i], hits[i]);
      if (IsRay(rays[i]))
        Nearest(rays[i], nearest, workspace);
      else
        ++workspace.counts.bad_rays;
    }
  }
  /// What Any finds for each of the rays; counts hits, and what is no ray.
  virtual void AnyOfEach(std::span<const R3::Ray> rays, bool* are_occluded, Workspace& workspace) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const bool is_ray = IsRay(rays[i]);
      are_occluded[i] = is_ray && Any(rays[i], workspace);
      workspace.counts.hits += are_occluded[i];
      workspace.counts.bad_rays += !is_ray;
    }
  }

  const World& world_;

 private:
  /// Everything that the ray may hit.
  void Search(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const {
    Nearest(ray, nearest, workspace);
    if (has_unbounded_) [[unlikely]]
      TestUnbounded(ray, nearest, workspace);
  }
  /// Shapes that no box holds, and so no structure: every ray asks them.
  void TestUnbounded(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const;
  void OfferUnbounded(const R3::Ray& ray, std::optional<WorldHit>& hit, Workspace& workspace) const;
  bool IsBehindUnbounded(const R3::Ray& ray, Workspace& workspace) const;
  /// The nearest hit, and all that are near enough to be coincident with it.
  std::vector<WorldHit> HitsNear(const R3::Ray& ray, const WorldHit& nearest, Workspace& workspace) const;
  /// Which one is seen where others may be coincident with the nearest hit.
  WorldHit Seen(const R3::Ray& ray, const WorldHit& nearest, Workspace& workspace) const;

  /// Offers all that may be the nearest hit.
  virtual void Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const = 0;
  virtual bool Any(const R3::Ray& ray, Workspace& workspace) const = 0;

  bool has_unbounded_;
};

/// One line of accelerators.def.
struct AcceleratorKind {
  const char* name;
  const char* about;
  std::unique_ptr<Accelerator> (*build)(const World& world, const AcceleratorSettings& settings);

  std::unique_ptr<Accelerator> Make(const World& world, const AcceleratorSettings& settings) const;
};

/// Every kind, in the order of accelerators.def.
std::span<const AcceleratorKind* const> AcceleratorKinds();
const AcceleratorKind* FindAcceleratorKind(const std::string& name);

}  // namespace ray

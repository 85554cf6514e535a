#pragma once

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

/// An acceleration structure. It decides which primitives a ray is tested against, never the result of a test. Every
/// accelerator returns bit-identical hits: the nearest t, and the choice of Contact.h where surfaces touch.
class Accelerator {
 public:
  /// Refers to `world`, which must outlive it.
  explicit Accelerator(const World& world) : world_(world), has_unbounded_(!world.Unbounded().empty()) {}
  virtual ~Accelerator() = default;

  /// Returns the nearest hit in (ray.t_min, ray.t_max).
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

  /// Returns true if anything lies in (ray.t_min, ray.t_max).
  bool IsOccluded(const R3::Ray& ray, Workspace& workspace) const {
    bool is_occluded = false;
    if (IsRay(ray))
      is_occluded = Any(ray, workspace) || (has_unbounded_ && IsBehindUnbounded(ray, workspace));
    else
      ++workspace.counts.bad_rays;
    if (is_occluded) ++workspace.counts.hits;
    return is_occluded;
  }

  /// Intersects each ray of a packet. Accelerators that trace packets are faster for coherent rays, such as those of
  /// neighboring pixels. Results go to hits[0], hits[1], ..., or to is_occluded.
  void Intersect(std::span<const R3::Ray> rays, std::optional<WorldHit>* hits, Workspace& workspace) const {
    NearestBatch(rays, hits, workspace);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (has_unbounded_ && IsRay(rays[i])) [[unlikely]]
        OfferUnbounded(rays[i], hits[i], workspace);
      if (!hits[i]) continue;
      if (hits[i]->is_contested) [[unlikely]]
        *hits[i] = Seen(rays[i], *hits[i], workspace);
      ++workspace.counts.hits;
    }
  }
  void IsOccluded(std::span<const R3::Ray> rays, bool* is_occluded, Workspace& workspace) const {
    AnyBatch(rays, is_occluded, workspace);
    if (!has_unbounded_) return;
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (!is_occluded[i] && IsRay(rays[i]) && IsBehindUnbounded(rays[i], workspace))
        is_occluded[i] = true, ++workspace.counts.hits;
  }

  /// Returns the hits that are coincident with a hit found by Intersect, including it, in the order in which they hide
  /// each other; see CoincidentOf.
  std::vector<WorldHit> Coincident(const R3::Ray& ray, const WorldHit& hit, Workspace& workspace) const;

  std::string kind;                  // a line of accelerators.def; for `auto`, the one that it chose
  std::vector<std::string> reasons;  // why `auto` chose it
  /// Describes the structure that was built, in lines for -explain.
  virtual std::vector<std::string> Explain() const { return {}; }
  /// Returns the number of levels of nested boxes, for the viewer; 0 if there are no boxes. BoxesAt returns the boxes
  /// of one level in the world; level 0 is the outermost. The structure inside a shared mesh contributes only the box
  /// around it.
  virtual int BoxLevels() const { return 0; }
  virtual std::vector<R3::Box> BoxesAt(int /*level*/) const { return {}; }
  /// Returns the bytes of memory that the structure takes, without the world.
  virtual std::size_t Bytes() const { return 0; }

 protected:
  /// Computes Nearest for each of the rays; no hit for invalid rays, see IsRay, which are counted.
  virtual void NearestBatch(std::span<const R3::Ray> rays, std::optional<WorldHit>* hits, Workspace& workspace) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      NearestHit nearest(world_, rays[i], hits[i]);
      if (IsRay(rays[i]))
        Nearest(rays[i], nearest, workspace);
      else
        ++workspace.counts.bad_rays;
    }
  }
  /// Computes Any for each of the rays; counts hits and invalid rays.
  virtual void AnyBatch(std::span<const R3::Ray> rays, bool* is_occluded, Workspace& workspace) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const bool is_ray = IsRay(rays[i]);
      is_occluded[i] = is_ray && Any(rays[i], workspace);
      workspace.counts.hits += is_occluded[i];
      workspace.counts.bad_rays += !is_ray;
    }
  }

  const World& world_;

 private:
  /// Searches all primitives that the ray may hit.
  void Search(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const {
    Nearest(ray, nearest, workspace);
    if (has_unbounded_) [[unlikely]]
      TestUnbounded(ray, nearest, workspace);
  }
  /// Tests the shapes that have no box and are therefore outside of the structure, against every ray.
  void TestUnbounded(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const;
  void OfferUnbounded(const R3::Ray& ray, std::optional<WorldHit>& hit, Workspace& workspace) const;
  bool IsBehindUnbounded(const R3::Ray& ray, Workspace& workspace) const;
  /// Returns the nearest hit, and all hits near enough to be coincident with it.
  std::vector<WorldHit> HitsNear(const R3::Ray& ray, const WorldHit& nearest, Workspace& workspace) const;
  /// Returns the visible one of the hits that may be coincident with the nearest hit.
  WorldHit Seen(const R3::Ray& ray, const WorldHit& nearest, Workspace& workspace) const;

  /// Offers all hits that may be the nearest.
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

/// Returns all kinds, in the order of accelerators.def.
std::span<const AcceleratorKind* const> AcceleratorKinds();
const AcceleratorKind* FindAcceleratorKind(const std::string& name);

}  // namespace ray

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "source/accelerate/Counts.h"

namespace ray {

/// What a ray is for. Transmission is straight or refracted; scattering is off diffuse surfaces.
enum class RayKind { camera, shadow, reflection, transmission, scattering };
inline constexpr std::array ray_kind_names{"camera", "shadow", "reflection", "transmission", "scattering"};

/// Rays by what they were for, and what tracing them cost.
struct RayCounts {
  struct Kind {
    std::uint64_t rays = 0;
    Counts cost;
    friend bool operator==(const Kind&, const Kind&) = default;
  };
  std::array<Kind, ray_kind_names.size()> kinds;
  std::uint64_t cut = 0;  // wanted, but a camera ray had reached its limit of descendants

  Kind& operator[](RayKind kind) { return kinds[static_cast<std::size_t>(kind)]; }
  const Kind& operator[](RayKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }

  std::uint64_t Total() const {
    std::uint64_t sum = 0;
    for (const Kind& kind : kinds) sum += kind.rays;
    return sum;
  }
  Counts Cost() const {
    Counts sum;
    for (const Kind& kind : kinds) sum += kind.cost;
    return sum;
  }
  RayCounts& operator+=(const RayCounts& o) {
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i].rays += o.kinds[i].rays, kinds[i].cost += o.kinds[i].cost;
    cut += o.cut;
    return *this;
  }
  friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

}  // namespace ray

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "source/accelerate/Counts.h"

namespace ray {

/// The purpose of a ray. Transmission is straight or refracted; diffuse rays are scattered by diffuse surfaces.
enum class RayKind : std::uint8_t { camera, shadow, reflection, transmission, diffuse };
inline constexpr std::array ray_kind_names{"camera", "shadow", "reflection", "transmission", "diffuse"};

/// Numbers of rays by purpose, with their cost.
struct RayCounts {
  struct Kind {
    std::uint64_t rays = 0;
    Counts cost;
    friend bool operator==(const Kind&, const Kind&) = default;
  };
  std::array<Kind, ray_kind_names.size()> kinds;
  std::uint64_t cut = 0;  // not traced because the camera ray had reached its limit of descendants
  // The luminance of throughputs at which settings ended paths, relative to a camera ray's. Integers, whose sum does
  // not depend on the order.
  std::uint64_t throughput_cut = 0;
  static constexpr double throughput_unit = 65536;
  std::uint64_t caustics = 0;  // paths that found the brightest light behind mirrors or glass, see Caustics

  /// Counts the end of a path with that luminance, at least 0 or NaN, though a longer one might carry light.
  void EndAt(double luminance) {
    constexpr double most = 1e6;  // so that the sum of 1e8 such paths fits; materials may reflect more than arrives
    throughput_cut += static_cast<std::uint64_t>(throughput_unit * (luminance < most ? luminance : most));
  }

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
    throughput_cut += o.throughput_cut;
    caustics += o.caustics;
    return *this;
  }
  friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

}  // namespace ray

#pragma once

#include <cstdint>

namespace ray {

/// Rays by what they were for.
struct RayCounts {
  std::uint64_t camera = 0, shadow = 0, reflection = 0, transmission = 0;  // transmission: straight and refracted
  std::uint64_t cut = 0;  // wanted, but a camera ray had reached its limit of descendants

  std::uint64_t Total() const { return camera + shadow + reflection + transmission; }
  RayCounts& operator+=(const RayCounts& o) {
    camera += o.camera, shadow += o.shadow, reflection += o.reflection, transmission += o.transmission, cut += o.cut;
    return *this;
  }
  friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

}  // namespace ray

#pragma once

#include <cstdint>

#include "R1/Columns.h"
#include "R2/Color.h"
#include "R2/Point.h"
#include "R3/Point.h"

namespace ray {

/// Samples of one light, each seen from a different point or all from the same: the contents of LightSample in columns.
struct LightSamples {
  static constexpr std::uint32_t most = R1::batch_size;
  using Each = double[most];

  std::uint32_t count = 0;
  R1::Columns<R3::Point> from;    // the illuminated points
  R1::Columns<R2::Point> random;  // in [0, 1)^2: selects the point on the light
  R1::Columns<R3::Vector> to_light;
  R1::Columns<R2::Color> color;  // the irradiance, 0 if the light does not shine; later the reflected part of it

  void Set(std::uint32_t i, const R3::Vector& way, const R2::Color& irradiance) {
    to_light.Set(i, way), color.Set(i, irradiance);
  }
};

}  // namespace ray

#pragma once

#include <cstdint>

#include "R1/BatchSize.h"
#include "R2/Color.h"
#include "R3/Point.h"

namespace ray {

/// Samples of one light, each as seen from a point of its own or all from one: what a LightSample
/// holds, but each number an array over the samples, so that loops become vector instructions.
struct LightSamples {
  static constexpr std::uint32_t most = R1::batch_size;
  using Each = double[most];

  std::uint32_t count = 0;
  alignas(64) Each from_x, from_y, from_z;  // what is lit
  alignas(64) Each u, v;                    // in [0, 1): pick the place on the light
  alignas(64) Each to_light_x, to_light_y, to_light_z;
  alignas(64) Each r, g, b;  // the irradiance, 0 where the light does not shine; later what is reflected of it

  R3::Point From(std::uint32_t i) const { return {from_x[i], from_y[i], from_z[i]}; }
  void SetFrom(std::uint32_t i, const R3::Point& p) { from_x[i] = p.x, from_y[i] = p.y, from_z[i] = p.z; }
  /// One point for all of them.
  void SetFrom(const R3::Point& p) {
    for (std::uint32_t i = 0; i < count; ++i) SetFrom(i, p);
  }
  R3::Vector ToLight(std::uint32_t i) const { return {to_light_x[i], to_light_y[i], to_light_z[i]}; }
  R2::Color Color(std::uint32_t i) const { return {r[i], g[i], b[i]}; }
  void Set(std::uint32_t i, const R3::Vector& to_light, const R2::Color& color) {
    to_light_x[i] = to_light.x, to_light_y[i] = to_light.y, to_light_z[i] = to_light.z;
    SetColor(i, color);
  }
  void SetColor(std::uint32_t i, const R2::Color& color) { r[i] = color.r, g[i] = color.g, b[i] = color.b; }
};

}  // namespace ray

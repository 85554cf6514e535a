#pragma once

#include <cstdint>

#include "R1/BatchSize.h"
#include "R2/Point.h"
#include "R3/Normal.h"
#include "R3/Point.h"

namespace R3 {

/// Places on one surface drawn at random, each as a point of its own sees it: what a SurfaceSample holds, but each
/// number an array over the samples, so that loops become vector instructions.
struct SurfaceSamples {
  static constexpr std::uint32_t most = R1::batch_size;
  using Each = double[most];

  std::uint32_t count = 0;
  alignas(64) Each from_x, from_y, from_z;  // what sees it
  alignas(64) Each u, v;                    // in [0, 1): pick the place
  alignas(64) Each x, y, z, error_x, error_y, error_z, normal_x, normal_y, normal_z;
  alignas(64) Each pdf;  // per solid angle; 0 where no place can be seen

  Point From(std::uint32_t i) const { return {from_x[i], from_y[i], from_z[i]}; }
  R2::Point Random(std::uint32_t i) const { return {u[i], v[i]}; }
  Point Position(std::uint32_t i) const { return {x[i], y[i], z[i]}; }
  Vector Error(std::uint32_t i) const { return {error_x[i], error_y[i], error_z[i]}; }
  Normal NormalAt(std::uint32_t i) const { return {normal_x[i], normal_y[i], normal_z[i]}; }
  void Set(std::uint32_t i, const Point& position, const Vector& error, const Vector& normal, double its_pdf) {
    x[i] = position.x, y[i] = position.y, z[i] = position.z;
    error_x[i] = error.x, error_y[i] = error.y, error_z[i] = error.z;
    normal_x[i] = normal.x, normal_y[i] = normal.y, normal_z[i] = normal.z;
    pdf[i] = its_pdf;
  }
};

}  // namespace R3

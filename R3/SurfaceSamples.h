#pragma once

#include <cstdint>

#include "R1/Columns.h"
#include "R2/Point.h"
#include "R3/Normal.h"
#include "R3/Point.h"

namespace R3 {

/// Random points on one surface, each seen from a different point: the contents of SurfaceSample in columns.
struct SurfaceSamples {
  static constexpr std::uint32_t most = R1::batch_size;

  std::uint32_t count = 0;
  R1::Columns<Point> from;        // the points that see the surface
  R1::Columns<R2::Point> random;  // in [0, 1)^2: selects the point
  R1::Columns<Point> position;
  R1::Columns<Vector> error;
  R1::Columns<Normal> normal;
  alignas(64) double pdf[most];  // per solid angle; 0 if no point can be seen

  void Set(std::uint32_t i, const Point& place, const Vector& its_error, const Normal& its_normal, double its_pdf) {
    position.Set(i, place), error.Set(i, its_error), normal.Set(i, its_normal);
    pdf[i] = its_pdf;
  }
};

}  // namespace R3

#pragma once

#include "R3/Point.h"

namespace R3 {

/// A sphere as numbers.
struct SphereData {
  Point center;
  double radius = 0;
};

}  // namespace R3

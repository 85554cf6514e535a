#include "R2/Plane.h"

namespace R2 {

double Mean(const Plane& plane) {
  double sum = 0;
  for (const float value : plane.values) sum += value;
  return plane.values.empty() ? 0 : sum / static_cast<double>(plane.values.size());
}

}  // namespace R2

#include "R3/Shape.h"

namespace R3 {

Box Bounds(const Shape& shape) {
  Box box;
  for (int i = 0; i < shape.Elements(); ++i) box.Extend(shape.Bounds(i));
  return box;
}

}  // namespace R3

#include "source/integrate/shading/Absorption.h"

#include "R1/Elementary.h"

namespace ray {

R2::Color LeftAfter(const R2::Color& absorb, double distance) {
  return {R1::Exp(-absorb.r * distance), R1::Exp(-absorb.g * distance), R1::Exp(-absorb.b * distance)};
}

}  // namespace ray

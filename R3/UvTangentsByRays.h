#pragma once

#include "R3/Shape.h"
#include "R3/UvTangents.h"

namespace R3 {

/// Shape::UvTangentsAt for a shape of which nothing is known but what rays find: they are sent down onto it beside the
/// hit, and the texture coordinates found there compared.
///   accuracy   with steps of 2^-15 of the shape's size to both sides truncation leaves about 2^-30 of what u and v
///              gain, on a surface that curves no more than its size says, and rounding 2^-35 near the origin, or 2^-15
///              a million sizes away from it; where one side finds nothing, as at an edge, truncation leaves 2^-15
UvTangents UvTangentsByRays(const Shape& shape, const Ray& ray, const Hit& hit, int element);

}  // namespace R3

#pragma once

#include "R2/Vector.h"
#include "R3/Vector.h"

namespace R3 {

/// How texture coordinates run over a surface around a place: what u and v gain over each of two tangents of any
/// length. Most shapes know dp/du and dp/dv, which gain (1, 0) and (0, 1); a triangle knows its sides and what its
/// corners say, which may be that v never changes, so that there is no dp/dv.
struct UvTangents {
  Vector first, second;  // across the geometric normal; parallel, or 0, where nothing is known
  R2::Vector gain_first{1, 0}, gain_second{0, 1};
};

}  // namespace R3

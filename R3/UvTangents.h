#pragma once

#include "R2/Vector.h"
#include "R3/Vector.h"

namespace R3 {

/// The change of texture coordinates over a surface around a point: the gains of u and v along two tangents of any
/// length. Most shapes know dp/du and dp/dv, with gains (1, 0) and (0, 1). A triangle knows its sides and its corners'
/// coordinates; v may be constant, in which case there is no dp/dv.
struct UvTangents {
  Vector first, second;  // perpendicular to the geometric normal; parallel or 0 if unknown
  R2::Vector gain_first{1, 0}, gain_second{0, 1};
};

}  // namespace R3

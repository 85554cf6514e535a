#pragma once

#include <vector>

#include "R3/ShapeKind.h"

/// The kinds of shape that lie in a box, as most tests need them.
inline std::vector<const R3::ShapeKind*> BoundedShapeKinds() {
  std::vector<const R3::ShapeKind*> kinds;
  for (const R3::ShapeKind* kind : R3::ShapeKinds())
    if (kind->make(kind->example)->IsBounded()) kinds.push_back(kind);
  return kinds;
}

inline std::vector<const R3::ShapeKind*> AllShapeKinds() { return {R3::ShapeKinds().begin(), R3::ShapeKinds().end()}; }

/// The kinds that tests/ExactScene.h can judge: all but patches and blobs, which tests/R3/Bezier.cpp and
/// tests/R3/Blob.cpp judge.
inline std::vector<const R3::ShapeKind*> JudgedShapeKinds() {
  std::vector<const R3::ShapeKind*> kinds = AllShapeKinds();
  for (const char* other : {"bezier", "bspline", "blob"}) std::erase(kinds, R3::FindShapeKind(other));
  return kinds;
}

#pragma once

#include "source/accelerate/wide/Tree.h"

namespace ray::wide {

struct BuildSettings {
  int leaf_size = width;              // most triangles of a leaf, 1 to `width`
  bool pre_splits_triangles = false;  // before building, so that slanted ones have tight boxes
};

/// A tree over the primitives by the surface area heuristic (SAH), binned, split from the top; in parallel, and the
/// same tree whatever the number of threads. At most `most_depth` deep.
///   source  MacDonald, Booth, Heuristics for ray tracing using space subdivision (1990); Wald, On fast construction of
///           SAH-based bounding volume hierarchies (2007); eight children a node: Wald, Benthin, Boulos, Getting rid of
///           packets (2008)
Tree Build(PrimitiveSet primitives, const BuildSettings& settings);

}  // namespace ray::wide

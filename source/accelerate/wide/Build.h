#pragma once

#include "source/accelerate/wide/Tree.h"

namespace ray::wide {

/// Builds a tree over the primitives top-down by the binned surface area heuristic (SAH); in parallel, with a result
/// that does not depend on the number of threads. At most `most_depth` deep.
///   source  MacDonald, Booth, Heuristics for ray tracing using space subdivision (1990); Wald, On fast construction of
///           SAH-based bounding volume hierarchies (2007); eight children per node: Wald, Benthin, Boulos, Getting rid
///           of
///           packets (2008)
///   leaf_size   maximum number of triangles in a leaf, 1 to `width`
Tree Build(PrimitiveSet primitives, int leaf_size);

}  // namespace ray::wide

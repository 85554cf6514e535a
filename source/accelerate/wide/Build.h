#pragma once

#include "source/accelerate/wide/Tree.h"

namespace ray::wide {

/// A tree over the primitives by the surface area heuristic (SAH), binned, split from the top; in parallel, and the
/// same tree whatever the number of threads. At most `most_depth` deep.
///   source  MacDonald, Booth, Heuristics for ray tracing using space subdivision (1990); Wald, On fast construction of
///           SAH-based bounding volume hierarchies (2007); eight children a node: Wald, Benthin, Boulos, Getting rid of
///           packets (2008)
///   leaf_size   most triangles of a leaf, 1 to `width`
Tree Build(PrimitiveSet primitives, int leaf_size);

}  // namespace ray::wide

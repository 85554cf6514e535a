#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake triangles_missing_mistake{
    .name = "triangles_missing",
    .title = "triangles and polygons are missing",
    .expected = "A hit of the plane is a hit of the triangle if it is inside all three edges.",
    .hint = "Does your test depend on the order of the corners?",
    .make =
        [](Variant& v) {
          RemoveShapes(v.OwnScene(), [](const R3::Shape& shape) { return !shape.IsSolid() && shape.IsBounded(); });
        },
};

}  // namespace ray::grade

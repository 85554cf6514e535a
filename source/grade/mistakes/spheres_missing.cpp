#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake spheres_missing_mistake{
    .name = "spheres_missing",
    .title = "spheres are missing",
    .expected = "The camera ray meets a sphere where |o + t d - c| = r; the nearest t in front of the eye counts.",
    .hint = "Does the quadratic equation find a root for a ray through the middle?",
    .make =
        [](Variant& v) {
          RemoveShapes(v.OwnScene(), [](const R3::Shape& shape) { return shape.AsSphere().has_value(); });
        },
};

}  // namespace ray::grade

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake flat_shading_mistake{
    .name = "flat_shading",
    .title = "meshes are shaded flat",
    .expected = "Normals at the corners are blended by the barycentric coordinates of the hit.",
    .hint = "Can you see the triangles?",
    .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::flat; },
};

}  // namespace ray::grade

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake normal_by_matrix_mistake{
    .name = "normal_by_matrix",
    .title = "normals are transformed like points",
    .expected = "Normals go by the inverse transpose of the matrix that moves points.",
    .hint = "Look at a sphere that is scaled along one axis.",
    .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::by_matrix; },
};

}  // namespace ray::grade

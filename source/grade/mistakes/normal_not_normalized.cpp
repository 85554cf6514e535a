#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake normal_not_normalized_mistake{
    .name = "normal_not_normalized",
    .title = "normals are not of unit length",
    .expected = "N has length 1 before any dot product is taken.",
    .hint = "Do spheres of another radius, or scaled ones, have another brightness?",
    .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::not_normalized; },
};

}  // namespace ray::grade

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake normal_inward_mistake{
    .name = "normal_inward",
    .title = "normals point inward",
    .expected = "N points outward, or to the side that the ray came from.",
    .hint = "Which sign has N.L on the lit side?",
    .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::inward; },
};

}  // namespace ray::grade

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake normal_untransformed_mistake{
    .name = "normal_untransformed",
    .title = "normals are not transformed",
    .expected = "A normal found in the object's own frame has to be brought into the world.",
    .hint = "Look at the shading of something that is rotated.",
    .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::untransformed; },
};

}  // namespace ray::grade

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake normal_not_facing_mistake{
    .name = "normal_not_facing",
    .title = "normals are not turned to the viewer",
    .expected = "A surface seen from behind is shaded with the normal on the viewer's side.",
    .hint = "Look at the inside of something open, or at a wall from behind.",
    .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::not_facing; },
};

}  // namespace ray::grade

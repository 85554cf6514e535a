#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake shadows_beyond_light_mistake{
    .name = "shadows_beyond_light",
    .title = "objects beyond a light cast shadows",
    .expected = "Only what is nearer than the light blocks it: hits farther away than the light do not count.",
    .hint = "Compare the distance of the hit with that of the light.",
    .make = [](Variant& v) { v.rules.shadow = ShadingRules::Shadow::beyond_light; },
};

}  // namespace ray::grade

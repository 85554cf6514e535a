#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake shadow_of_next_light_mistake{
    .name = "shadow_of_next_light",
    .title = "each light has the shadows of another one",
    .expected = "Each light is blocked by what lies towards this light.",
    .hint = "Which light's position does the shadow ray get?",
    .make = [](Variant& v) { v.rules.shadow = ShadingRules::Shadow::of_next_light; },
};

}  // namespace ray::grade

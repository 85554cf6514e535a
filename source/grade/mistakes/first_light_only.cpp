#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake first_light_only_mistake{
    .name = "first_light_only",
    .title = "only the first light counts",
    .expected = "The terms of all lights are added up.",
    .hint = "Does the loop over the lights end early?",
    .make = [](Variant& v) { v.rules.lights = ShadingRules::Lights::first; },
};

}  // namespace ray::grade

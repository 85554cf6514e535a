#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake highlight_in_shadow_mistake{
    .name = "highlight_in_shadow",
    .title = "highlights in places that do not see the light",
    .expected = "A light that is blocked gives neither its diffuse term nor its highlight.",
    .hint = "What does your shadow test skip: the whole light, or one term?",
    .make = [](Variant& v) { v.rules.highlight_in_shadow = true; },
};

}  // namespace ray::grade

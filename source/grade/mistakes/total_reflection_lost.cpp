#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake total_reflection_lost_mistake{
    .name = "total_reflection_lost",
    .title = "total internal reflection is lost",
    .expected = "Where no ray can leave, all of the light is reflected.",
    .hint = "What happens where the root in Snell's law has no solution?",
    .make = [](Variant& v) { v.settings.trace.fresnel = v.settings.trace.internal_reflection = false; },
};

}  // namespace ray::grade

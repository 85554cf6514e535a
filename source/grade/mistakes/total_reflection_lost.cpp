#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake total_reflection_lost_mistake{
    .name = "total_reflection_lost",
    .title = "glass reflects nothing, not even where no light can leave it",
    .expected = "Light that is not refracted is reflected; where no ray can leave, all of it is.",
    .hint = "What happens where the root in Snell's law has no solution?",
    .make = [](Variant& v) { v.settings.trace.fresnel = v.settings.trace.internal_reflection = false; },
};

}  // namespace ray::grade

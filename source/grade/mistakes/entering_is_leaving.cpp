#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake entering_is_leaving_mistake{
    .name = "entering_is_leaving",
    .title = "rays that enter glass bend as if they left it",
    .expected = "On entering, the ratio of the indices is 1 / n.",
    .hint = "How does your program know that a ray is outside?",
    .make = [](Variant& v) { v.rules.always_leaves_glass = true; },
};

}  // namespace ray::grade

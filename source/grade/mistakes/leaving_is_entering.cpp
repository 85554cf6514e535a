#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake leaving_is_entering_mistake{
    .name = "leaving_is_entering",
    .title = "rays that leave glass bend as if they entered it",
    .expected = "On leaving, the roles of the two indices are swapped.",
    .hint = "How does your program know that a ray is inside?",
    .make = [](Variant& v) { v.rules.leaving_is_entering = true; },
};

}  // namespace ray::grade

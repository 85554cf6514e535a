#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake one_bounce_less_mistake{
    .name = "one_bounce_less",
    .title = "one bounce too few",
    .expected = "Rays are followed for as many bounces as the maximum depth says.",
    .hint = "Is the camera ray counted as a bounce?",
    .make =
        [](Variant& v) {
          if (v.settings.trace.max_depth > 0) --v.settings.trace.max_depth;
        },
};

}  // namespace ray::grade

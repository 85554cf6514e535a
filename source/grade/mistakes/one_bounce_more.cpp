#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake one_bounce_more_mistake{
    .name = "one_bounce_more",
    .title = "one bounce too many",
    .expected = "Rays are followed for as many bounces as the maximum depth says.",
    .hint = "Is the depth compared with < or with <=?",
    .make = [](Variant& v) { ++v.settings.trace.max_depth; },
};

}  // namespace ray::grade

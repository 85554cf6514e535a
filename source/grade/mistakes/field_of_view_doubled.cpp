#include <algorithm>

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake field_of_view_doubled_mistake{
    .name = "field_of_view_doubled",
    .title = "the field of view is twice as wide",
    .expected = "The angle in the scene file is used as the course defines it: whole or half, horizontal or vertical.",
    .hint = "Is everything half as large?",
    .make =
        [](Variant& v) {
          double& angle = v.OwnScene().camera.xfov;
          angle = std::min(2 * angle, 1.5);
        },
};

}  // namespace ray::grade

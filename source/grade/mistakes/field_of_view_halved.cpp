#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake field_of_view_halved_mistake{
    .name = "field_of_view_halved",
    .title = "the field of view is half as wide",
    .expected = "The angle in the scene file is used as the course defines it: whole or half, horizontal or vertical.",
    .hint = "Is everything twice as large?",
    .make = [](Variant& v) { v.OwnScene().camera.xfov /= 2; },
};

}  // namespace ray::grade

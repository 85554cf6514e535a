#include "R1/Elementary.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake field_of_view_of_height_mistake{
    .name = "field_of_view_of_height",
    .title = "the field of view is taken across the other side of the image",
    .expected =
        "The angle is across the width or across the height, as the course says; the other follows from the aspect.",
    .hint = "Try a wide and a tall image of one scene.",
    .make =
        [](Variant& v) {
          double& angle = v.OwnScene().camera.xfov;
          angle = R1::Atan(R1::Tan(angle) * v.settings.width / v.settings.height);
        },
};

}  // namespace ray::grade

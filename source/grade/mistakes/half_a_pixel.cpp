#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake half_a_pixel_mistake{
    .name = "half_a_pixel",
    .title = "rays go through the corners of pixels",
    .expected = "A ray goes through the middle of its pixel: (x + 0.5) / width.",
    .hint = "Is there an offset of half a pixel between the images?",
    .make =
        [](Variant& v) {
          const double half_pixel = 1.0 / v.settings.width;
          R2::Vector& shift = v.OwnScene().camera.shift;
          shift = {shift.x - half_pixel, shift.y + half_pixel};
        },
};

}  // namespace ray::grade

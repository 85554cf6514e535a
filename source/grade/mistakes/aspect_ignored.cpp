#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake aspect_ignored_mistake{
    .name = "aspect_ignored",
    .title = "the image is stretched: the aspect ratio is ignored",
    .expected = "Pixels are square: height and width of the image plane are in the proportion of the pixels.",
    .hint = "Are spheres round in an image that is not square?",
    .make = [](Variant& v) { v.OwnScene().camera.aspect = 1; },
};

}  // namespace ray::grade

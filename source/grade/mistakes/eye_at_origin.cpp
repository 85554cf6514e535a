#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake eye_at_origin_mistake{
    .name = "eye_at_origin",
    .title = "the camera is at the origin",
    .expected = "Rays start at the eye.",
    .hint = "Where do your camera rays start?",
    .make = [](Variant& v) { v.OwnScene().camera.eye = {}; },
};

}  // namespace ray::grade

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake looks_backwards_mistake{
    .name = "looks_backwards",
    .title = "the camera looks backwards",
    .expected = "The view direction goes from the eye to what is looked at.",
    .hint = "What is behind the camera?",
    .make =
        [](Variant& v) {
          Camera& camera = v.OwnScene().camera;
          camera.towards = -camera.towards;
          camera.right = -camera.right;
        },
};

}  // namespace ray::grade

#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_background_mistake{
    .name = "no_background",
    .title = "the background is black",
    .expected = "A ray that hits nothing sees the scene's background.",
    .hint = "What does a ray return that hits nothing?",
    .make = [](Variant& v) { v.OwnScene().background = {}; },
};

}  // namespace ray::grade

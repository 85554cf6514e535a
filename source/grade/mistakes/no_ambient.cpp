#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_ambient_mistake{
    .name = "no_ambient",
    .title = "no ambient light",
    .expected = "Every surface reflects ka Ia, lit or not: I = ka Ia + sum over the lights.",
    .hint = "Look at a place in full shadow: it should not be black.",
    .make = [](Variant& v) { v.OwnScene().ambient = {}; },
};

}  // namespace ray::grade

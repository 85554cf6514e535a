#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake transforms_reversed_mistake{
    .name = "transforms_reversed",
    .title = "nested transforms are multiplied in the wrong order",
    .expected = "A point goes through its own matrix first, then through its parent's: M = M_parent M_child.",
    .hint = "Which of two nested groups acts first?",
    .make = [](Variant& v) { ReverseTransforms(v.OwnScene()); },
};

}  // namespace ray::grade

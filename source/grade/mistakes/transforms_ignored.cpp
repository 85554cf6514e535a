#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake transforms_ignored_mistake{
    .name = "transforms_ignored",
    .title = "transforms are ignored",
    .expected = "Every shape is placed by the matrices of the groups around it.",
    .hint = "Is everything where its own line puts it?",
    .make = [](Variant& v) { ChangeTransforms(v.OwnScene(), [](const R3::Matrix&) { return R3::Matrix{}; }); },
};

}  // namespace ray::grade

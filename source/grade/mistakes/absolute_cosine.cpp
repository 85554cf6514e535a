#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake absolute_cosine_mistake{
    .name = "absolute_cosine",
    .title = "light from behind the surface counts",
    .expected = "Where N.L is not positive, the light is behind the surface and adds nothing.",
    .hint = "What happens to a negative N.L?",
    .make = [](Variant& v) { v.rules.cosine = ShadingRules::Cosine::absolute; },
};

}  // namespace ray::grade

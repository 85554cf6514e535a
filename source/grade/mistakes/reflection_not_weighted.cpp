#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake reflection_not_weighted_mistake{
    .name = "reflection_not_weighted",
    .title = "reflections at full strength",
    .expected = "What the mirror ray sees is multiplied by the reflectance, channel by channel.",
    .hint = "What multiplies the color that the mirror ray returns?",
    .make =
        [](Variant& v) {
          ChangeMaterials(v.OwnScene(), [](Material& m) {
            if (!IsBlack(m.kr)) m.kr = {1, 1, 1};
          });
        },
};

}  // namespace ray::grade

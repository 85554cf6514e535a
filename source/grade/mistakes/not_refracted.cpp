#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake not_refracted_mistake{
    .name = "not_refracted",
    .title = "rays go straight through glass",
    .expected = "Snell's law: n1 sin a1 = n2 sin a2, with both angles to the normal.",
    .hint = "Hold a straight line behind the glass: is it bent?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ir = 1; }); },
};

}  // namespace ray::grade

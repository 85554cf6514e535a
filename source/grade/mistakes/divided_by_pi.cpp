#include <numbers>

#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake divided_by_pi_mistake{
    .name = "divided_by_pi",
    .title = "light is divided by pi",
    .expected = "In this course's units a light of color 1 that falls straight on kd 1 gives 1.",
    .hint = "Is everything a third as bright?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kd = m.kd / std::numbers::pi; }); },
};

}  // namespace ray::grade

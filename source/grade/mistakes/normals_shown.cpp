#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake normals_shown_mistake{
    .name = "normals_shown",
    .title = "normals are shown as colors",
    .expected = "I = ka Ia + sum over the lights of (kd (N.L) + ks (V.R)^n) IL.",
    .hint = "Was a test of the normals left in the program?",
    .make = [](Variant& v) { v.settings.mode = RenderMode::normal_color; },
};

}  // namespace ray::grade

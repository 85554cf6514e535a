#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake shape_colors_only_mistake{
    .name = "shape_colors_only",
    .title = "surfaces have their plain color, unlit",
    .expected = "I = ka Ia + sum over the lights of (kd (N.L) + ks (V.R)^n) IL.",
    .hint = "Is the color of a hit that of its material, whatever the lights?",
    .make = [](Variant& v) { v.settings.mode = RenderMode::flat; },
};

}  // namespace ray::grade

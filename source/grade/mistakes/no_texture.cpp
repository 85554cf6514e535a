#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_texture_mistake{
    .name = "no_texture",
    .title = "textures are ignored",
    .expected = "A texture's color at (u, v) multiplies the diffuse color.",
    .hint = "Is the image file read?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.texture.reset(); }); },
};

}  // namespace ray::grade

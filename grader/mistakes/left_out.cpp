#include "grader/mistakes/Tables.h"

#include "grader/Changes.h"

namespace ray::grade {

extern const MistakeTable left_out_mistakes{
    {.name = "no_background",
     .title = "the background is black",
     .expected = "A ray that hits nothing sees the scene's background.",
     .hint = "What does a ray return that hits nothing?",
     .make = [](Variant& v) { v.OwnScene().background = {}; }},
    {.name = "no_texture",
     .title = "textures are ignored",
     .expected = "A texture's color at (u, v) multiplies the diffuse color.",
     .hint = "Is the image file read?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.texture.reset(); }); }},
    {.name = "no_emission",
     .title = "emission is ignored",
     .expected = "A surface adds its own emission to what it reflects.",
     .hint = "Look at a surface that shines though no light reaches it.",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.emission = {}; }); }},
};

}  // namespace ray::grade

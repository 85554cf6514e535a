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
    {.name = "u_flipped",
     .title = "textures are mirrored",
     .expected = "A texture lies with u to the right and v up, its first row at the top.",
     .hint = "Can writing on a texture be read?",
     .make =
         [](Variant& v) {
           ChangeTextures(v.OwnScene(), [](const R2::Image& image) {
             return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
               return PixelPlace{image.Width() - 1 - x, y};
             });
           });
         }},
    {.name = "v_flipped",
     .title = "textures are upside down",
     .expected = "A texture lies with u to the right and v up, its first row at the top.",
     .hint = "Is the first row of the file v = 1?",
     .make =
         [](Variant& v) {
           ChangeTextures(v.OwnScene(), [](const R2::Image& image) {
             return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
               return PixelPlace{x, image.Height() - 1 - y};
             });
           });
         }},
    {.name = "uv_swapped",
     .title = "u and v of textures are swapped",
     .expected = "A texture lies with u to the right and v up, its first row at the top.",
     .hint = "Which of u and v counts the columns?",
     .make =
         [](Variant& v) {
           ChangeTextures(v.OwnScene(), [](const R2::Image& image) {
             return Moved(image, image.Height(), image.Width(), [](int x, int y) { return PixelPlace{y, x}; });
           });
         }},
    {.name = "nearest_texel",
     .title = "textures are not interpolated",
     .expected = "Between texel centers the color is interpolated, in u and in v.",
     .hint = "Can you see the texels as squares?",
     .make =
         [](Variant& v) {
           ChangeTextures(v.OwnScene(), [](const R2::Image& image) {
             constexpr int copies = 16;  // of a texel along each axis, between which there is nothing to interpolate
             return Moved(image, copies * image.Width(), copies * image.Height(), [](int x, int y) {
               return PixelPlace{x / copies, y / copies};
             });
           });
         }},
    {.name = "pole_along_y",
     .title = "spheres carry textures with their poles along y",
     .expected = "The poles of a sphere's texture lie along z.",
     .hint = "Around which axis does your u turn?",
     .make = [](Variant& v) { PutPolesAlongY(v.OwnScene()); }},
    {.name = "texture_repeated",
     .title = "textures repeat twice as often",
     .expected = "u and v run from 0 to 1 over a surface.",
     .hint = "Are u and v in 0 to 1, or in -1 to 1?",
     .make =
         [](Variant& v) {
           ChangeMaterials(v.OwnScene(), [](Material& m) {
             m.texture_scale = {2 * m.texture_scale.x, 2 * m.texture_scale.y};
           });
         }},
    {.name = "texture_replaces",
     .title = "textures replace the diffuse color",
     .expected = "A texture's color at (u, v) multiplies the diffuse color.",
     .hint = "Is kd still a factor where there is a texture?",
     .make =
         [](Variant& v) {
           ChangeMaterials(v.OwnScene(), [](Material& m) {
             if (m.texture) m.kd = {1, 1, 1};
           });
         }},
    {.name = "texture_on_ambient",
     .title = "textures multiply the ambient color, too",
     .expected = "A texture's color at (u, v) multiplies the diffuse color alone.",
     .hint = "Which terms does your texture multiply?",
     .make =
         [](Variant& v) {
           ChangeMaterials(v.OwnScene(), [](Material& m) {
             if (m.texture) m.texture_multiplies_ka = true;
           });
         }},
};

}  // namespace ray::grade

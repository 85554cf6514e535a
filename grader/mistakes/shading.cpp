#include "grader/mistakes/Tables.h"

#include <utility>

#include "grader/Changes.h"

namespace ray::grade {

extern const MistakeTable shading_mistakes{
    {.name = "no_ambient",
     .title = "no ambient light",
     .expected = "Every surface reflects ka Ia, lit or not: I = ka Ia + sum over the lights.",
     .hint = "Look at a place in full shadow: it should not be black.",
     .make = [](Variant& v) { v.OwnScene().ambient = {}; }},
    {.name = "ambient_per_light",
     .title = "ambient light added once per light",
     .expected = "ka Ia is added once per point, outside of the sum over the lights.",
     .hint = "Count how often the ambient term is added where two lights shine.",
     .make =
         [](Variant& v) {
           Scene& scene = v.OwnScene();
           scene.ambient = static_cast<double>(scene.lights.size()) * scene.ambient;
         }},
    {.name = "no_diffuse",
     .title = "no diffuse term",
     .expected = "Diffuse reflection is kd (N.L) IL, for each light that a point sees.",
     .hint = "Away from highlights, does turning a light off change anything?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kd = {}; }); }},
    {.name = "no_highlight",
     .title = "no highlights",
     .expected = "Phong's highlight is ks (V.R)^n IL, with R the light's direction mirrored about the normal.",
     .hint = "Look for a bright spot on the shiniest surface.",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ks = {}; }); }},
    {.name = "exponent_ignored",
     .title = "the shininess exponent is ignored",
     .expected = "The highlight is (V.R) to the power of the material's exponent n.",
     .hint = "How large is the highlight as n grows?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.n = 1; }); }},
    {.name = "half_vector",
     .title = "the half vector in place of the mirrored light",
     .expected =
         "This course's highlight is (V.R)^n: R is the light's direction mirrored about N, V points to the viewer.",
     .hint = "(N.H)^n is Blinn's highlight, which is wider than Phong's.",
     .make = [](Variant& v) { v.rules.half_vector = true; }},
    {.name = "highlight_in_surface_color",
     .title = "highlights tinted by the diffuse color",
     .expected = "The highlight is ks (V.R)^n IL; kd has no part in it.",
     .hint = "Compare the color of the highlight with that of the light.",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ks = m.ks * m.kd; }); }},
    {.name = "highlight_in_shadow",
     .title = "highlights in places that do not see the light",
     .expected = "A light that is blocked gives neither its diffuse term nor its highlight.",
     .hint = "What does your shadow test skip: the whole light, or one term?",
     .make = [](Variant& v) { v.rules.highlight_in_shadow = true; }},
    {.name = "no_cosine",
     .title = "no cosine: surfaces are as bright at any angle to the light",
     .expected = "Diffuse reflection falls with the cosine N.L of the angle to the light.",
     .hint = "How bright is a sphere near the line where light and shade meet?",
     .make = [](Variant& v) { v.rules.cosine = ShadingRules::Cosine::none; }},
    {.name = "absolute_cosine",
     .title = "light from behind the surface counts",
     .expected = "Where N.L is not positive, the light is behind the surface and adds nothing.",
     .hint = "What happens to a negative N.L?",
     .make = [](Variant& v) { v.rules.cosine = ShadingRules::Cosine::absolute; }},
    {.name = "ambient_by_diffuse",
     .title = "ambient light reflected by the diffuse color",
     .expected = "Ambient light is reflected by ka: ka Ia.",
     .hint = "Compare surfaces whose ka and kd differ.",
     .make =
         [](Variant& v) {
           ChangeMaterials(v.OwnScene(), [](Material& m) { m.ka = m.kd, m.texture_multiplies_ka = true; });
         }},
    {.name = "ambient_and_diffuse_swapped",
     .title = "the ambient and the diffuse color are swapped",
     .expected = "A material's colors stand in the order of the file: ambient, diffuse, specular.",
     .hint = "In which order are the colors read?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { std::swap(m.ka, m.kd); }); }},
    {.name = "ambient_light_ignored",
     .title = "the color of ambient light is ignored",
     .expected = "The ambient term is ka times the scene's ambient light Ia.",
     .hint = "Change the scene's ambient line: does the image change?",
     .make =
         [](Variant& v) {
           v.OwnScene().ambient = {1, 1, 1};
         }},
    {.name = "emission_per_light",
     .title = "emission added once per light",
     .expected = "Emission is added once per point, outside of the sum over the lights.",
     .hint = "Is a shining surface brighter when there are two lights?",
     .make =
         [](Variant& v) {
           Scene& scene = v.OwnScene();
           const auto count = static_cast<double>(scene.lights.size());
           ChangeMaterials(scene, [&](Material& m) { m.emission = count * m.emission; });
         }},
    {.name = "exponent_halved",
     .title = "the shininess exponent is halved",
     .expected = "The highlight is (V.R) to the power of the material's exponent n.",
     .hint = "Are highlights too wide?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.n /= 2; }); }},
    {.name = "exponent_doubled",
     .title = "the shininess exponent is doubled",
     .expected = "The highlight is (V.R) to the power of the material's exponent n.",
     .hint = "Are highlights too small?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.n *= 2; }); }},
    {.name = "cosine_squared",
     .title = "the cosine counts twice",
     .expected = "Diffuse reflection falls with the cosine N.L of the angle to the light.",
     .hint = "Is the cosine multiplied in two places?",
     .make = [](Variant& v) { v.rules.cosine = ShadingRules::Cosine::squared; }},
    {.name = "highlight_by_cosine",
     .title = "highlights fade with the cosine to the light",
     .expected = "The highlight is ks (V.R)^n IL; N.L has no part in it.",
     .hint = "What is multiplied by N.L: the sum of both terms?",
     .make = [](Variant& v) { v.rules.highlight_by_cosine = true; }},
    {.name = "highlight_opposite",
     .title = "highlights lie opposite to where they should",
     .expected = "R = 2 (N.L) N - L leaves the surface, and V points to the viewer.",
     .hint = "Which signs have R and V?",
     .make = [](Variant& v) { v.rules.highlight_opposite = true; }},
    {.name = "highlight_behind",
     .title = "highlights of lights behind the surface",
     .expected = "Where N.L is not positive, the light is behind the surface and adds neither term.",
     .hint = "What does your program check before it computes (V.R)^n?",
     .make = [](Variant& v) { v.rules.highlight_behind = true; }},
};

}  // namespace ray::grade

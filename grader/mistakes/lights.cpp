#include "grader/mistakes/Tables.h"

#include <numbers>
#include <utility>

#include "grader/Changes.h"

namespace ray::grade {

extern const MistakeTable lights_mistakes{
    {.name = "light_color_ignored",
     .title = "the color of lights is ignored",
     .expected = "All terms of a light are multiplied, channel by channel, by its color.",
     .hint = "Try one red light.",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             for (const char* channel : {"r", "g", "b"})
               if (double* value = light.At(channel); value && *value > 0) *value = 1;
           });
         }},
    {.name = "first_light_only",
     .title = "only the first light counts",
     .expected = "The terms of all lights are added up.",
     .hint = "Does the loop over the lights end early?",
     .make = [](Variant& v) { v.rules.lights = ShadingRules::Lights::first; }},
    {.name = "last_light_only",
     .title = "only the last light counts",
     .expected = "The terms of all lights are added up.",
     .hint = "Is the sum kept from one light to the next?",
     .make = [](Variant& v) { v.rules.lights = ShadingRules::Lights::last; }},
    {.name = "no_attenuation",
     .title = "light does not fade with distance",
     .expected = "Light from a place arrives divided by ca + la d + qa d^2, d the distance.",
     .hint = "Move a point light away: the scene should darken.",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             if (light.kind == "dir_light") return;
             if (double* ca = light.At("ca")) *ca = 1, *light.At("la") = 0, *light.At("qa") = 0;
           });
         }},
    {.name = "inverse_square_always",
     .title = "light always fades with the square of the distance",
     .expected = "Light fades as the scene file says: divided by ca + la d + qa d^2.",
     .hint = "Which of the three coefficients does your program read?",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             if (double* ca = light.At("ca")) *ca = 0, *light.At("la") = 0, *light.At("qa") = 1;
           });
         }},
    {.name = "spot_cutoff_ignored",
     .title = "spot lights have no cone",
     .expected = "Beyond its cut-off angle a spot light gives nothing.",
     .hint = "Look for the rim of the cone on the floor.",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             if (double* cutoff = light.At("sc")) *cutoff = std::numbers::pi;
           });
         }},
    {.name = "spot_exponent_ignored",
     .title = "spot lights do not fade towards the rim",
     .expected = "Within the cone, light is multiplied by the cosine of the angle to the axis, to the power sd.",
     .hint = "How bright is the middle of the cone compared with its rim?",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             if (double* exponent = light.At("sd")) *exponent = 0;
           });
         }},
    {.name = "spot_whole_angle",
     .title = "the cut-off angle of spot lights is taken for the whole cone",
     .expected = "The cut-off is the angle between axis and rim: half of the cone.",
     .hint = "Is the lit disc half as wide as expected?",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             if (double* cutoff = light.At("sc")) *cutoff /= 2;
           });
         }},
    {.name = "directional_reversed",
     .title = "directional lights shine backwards",
     .expected = "A directional light's vector is where the light goes; towards the light is its opposite.",
     .hint = "Which side of a sphere is lit?",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             for (const char* axis : {"dx", "dy", "dz"})
               if (double* value = light.At(axis); value && light.kind == "dir_light") *value = -*value;
           });
         }},
    {.name = "no_shadows",
     .title = "no shadows",
     .expected = "A light counts only where nothing lies between the point and the light.",
     .hint = "Is a ray sent from the point to each light?",
     .make = [](Variant& v) { v.settings.trace.shadows = false; }},
    {.name = "shadows_beyond_light",
     .title = "objects beyond a light cast shadows",
     .expected = "Only surfaces nearer than the light block it: hits beyond the light do not count.",
     .hint = "Compare the distance of the hit with that of the light.",
     .make = [](Variant& v) { v.rules.shadow = ShadingRules::Shadow::beyond_light; }},
    {.name = "shadow_of_next_light",
     .title = "each light has the shadows of another one",
     .expected = "Each light is blocked only by surfaces on the way to it.",
     .hint = "Which light's position does the shadow ray get?",
     .make = [](Variant& v) { v.rules.shadow = ShadingRules::Shadow::of_next_light; }},
    {.name = "attenuation_swapped",
     .title = "the coefficients of attenuation are read in the wrong order",
     .expected = "In the file they stand as ca, la, qa: constant, linear, quadratic.",
     .hint = "Which of the three is multiplied by d^2?",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             if (double* ca = light.At("ca")) std::swap(*ca, *light.At("qa"));
           });
         }},
    {.name = "constant_attenuation_ignored",
     .title = "the constant part of attenuation is ignored",
     .expected = "Light fades as the scene file says: divided by ca + la d + qa d^2.",
     .hint = "How bright is a place very near a light?",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             if (double* ca = light.At("ca"); ca && *light.At("la") + *light.At("qa") > 0) *ca = 0;
           });
         }},
    {.name = "attenuation_multiplied",
     .title = "light is multiplied by its attenuation",
     .expected = "Light from a place arrives divided by ca + la d + qa d^2.",
     .hint = "Does light grow with the distance?",
     .make = [](Variant& v) { v.rules.fading = ShadingRules::Fading::multiplied; }},
    {.name = "distance_squared",
     .title = "attenuation has the squared distance in place of the distance",
     .expected = "d is the distance itself, the length of the vector to the light.",
     .hint = "Is there a square root in the distance?",
     .make = [](Variant& v) { v.rules.fading = ShadingRules::Fading::of_square; }},
    {.name = "spot_linear",
     .title = "spot lights fade linearly with the angle",
     .expected = "Within the cone, light is multiplied by the cosine of the angle to the axis, to the power sd.",
     .hint = "Which part has the exponent sd in your program?",
     .make = [](Variant& v) { v.rules.spot_is_linear = true; }},
    {.name = "spot_backwards",
     .title = "spot lights shine backwards",
     .expected = "The direction in the file is where the axis of the cone goes.",
     .hint = "Which vector does the dot product with the axis get?",
     .make =
         [](Variant& v) {
           ChangeLights(v.OwnScene(), [](LightArguments& light) {
             for (const char* axis : {"dx", "dy", "dz"})
               if (double* value = light.At(axis); value && light.kind == "spot_light") *value = -*value;
           });
         }},
    {.name = "lights_averaged",
     .title = "lights are averaged",
     .expected = "The terms of all lights are added up.",
     .hint = "Is the sum divided by the number of lights?",
     .make =
         [](Variant& v) {
           Scene& scene = v.OwnScene();
           const auto count = static_cast<double>(scene.lights.size());
           ChangeLights(scene, [&](LightArguments& light) {
             for (const char* channel : {"r", "g", "b"})
               if (double* value = light.At(channel)) *value /= count;
           });
         }},
    {.name = "glass_casts_no_shadow",
     .title = "transparent things cast no shadows",
     .expected = "In this course a shadow ray is blocked by whatever lies before the light, glass too.",
     .hint = "Does your shadow test look at the material?",
     .make = [](Variant& v) { v.depth.glass_casts_no_shadow = true; }},
};

}  // namespace ray::grade

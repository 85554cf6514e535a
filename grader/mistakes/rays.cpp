#include "grader/mistakes/Tables.h"

#include "grader/Changes.h"

namespace ray::grade {

extern const MistakeTable rays_mistakes{
    {.name = "no_reflection",
     .title = "no reflections",
     .expected = "The color that a mirror ray sees is added, weighted by the mirror's reflectance.",
     .hint = "Do mirrors spawn a reflected ray?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kr = {}; }); }},
    {.name = "one_bounce_less",
     .title = "one bounce too few",
     .expected = "Rays are followed for as many bounces as the maximum depth says.",
     .hint = "Is the camera ray counted as a bounce?",
     .make =
         [](Variant& v) {
           if (v.settings.trace.max_depth > 0) --v.settings.trace.max_depth;
         }},
    {.name = "one_bounce_more",
     .title = "one bounce too many",
     .expected = "Rays are followed for as many bounces as the maximum depth says.",
     .hint = "Is the depth compared with < or with <=?",
     .make = [](Variant& v) { ++v.settings.trace.max_depth; }},
    {.name = "reflection_not_weighted",
     .title = "reflections at full strength",
     .expected = "The color that the mirror ray sees is multiplied by the reflectance, channel by channel.",
     .hint = "What multiplies the color that the mirror ray returns?",
     .make =
         [](Variant& v) {
           ChangeMaterials(v.OwnScene(), [](Material& m) {
             if (!IsBlack(m.kr)) m.kr = {1, 1, 1};
           });
         }},
    {.name = "reflection_weighted_twice",
     .title = "reflections are weighted twice",
     .expected = "The color that the mirror ray sees is multiplied by the mirror's reflectance, once.",
     .hint = "Is the color that returns multiplied in two places?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kr = m.kr * m.kr; }); }},
    {.name = "reflection_gray",
     .title = "reflections are not tinted",
     .expected = "The color that the mirror ray sees is multiplied by the reflectance, channel by channel.",
     .hint = "Is the reflectance one number where three are due?",
     .make =
         [](Variant& v) {
           ChangeMaterials(v.OwnScene(), [](Material& m) {
             const double gray = Luminance(m.kr);
             m.kr = {gray, gray, gray};
           });
         }},
    {.name = "reflection_in_surface_color",
     .title = "reflections tinted by the diffuse color",
     .expected = "The color that the mirror ray sees is multiplied by the mirror's reflectance only.",
     .hint = "Which color multiplies the reflection?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kr = m.kr * m.kd; }); }},
    {.name = "no_transmission",
     .title = "nothing is seen through transparent surfaces",
     .expected = "The color seen through a surface is added, weighted by its transmittance.",
     .hint = "Does glass spawn a transmitted ray?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kt = {}; }); }},
    {.name = "not_refracted",
     .title = "rays go straight through glass",
     .expected = "Snell's law: n1 sin a1 = n2 sin a2, with both angles to the normal.",
     .hint = "Hold a straight line behind the glass: is it bent?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ir = 1; }); }},
    {.name = "refraction_inverted",
     .title = "the index of refraction is inverted",
     .expected = "On entering, sin a2 = sin a1 / n; on leaving, sin a2 = n sin a1.",
     .hint = "Do rays bend towards the normal as they enter?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ir = 1 / m.ir; }); }},
    {.name = "leaving_is_entering",
     .title = "rays that leave glass bend as if they entered it",
     .expected = "On leaving, the roles of the two indices are swapped.",
     .hint = "How does your program know that a ray is inside?",
     .make = [](Variant& v) { v.rules.leaving_is_entering = true; }},
    {.name = "entering_is_leaving",
     .title = "rays that enter glass bend as if they left it",
     .expected = "On entering, the ratio of the indices is 1 / n.",
     .hint = "How does your program know that a ray is outside?",
     .make = [](Variant& v) { v.rules.always_leaves_glass = true; }},
    {.name = "total_reflection_lost",
     .title = "glass reflects nothing, not even where no light can leave it",
     .expected = "Light that is not refracted is reflected; where no ray can leave, all of it is.",
     .hint = "What happens where the root in Snell's law has no solution?",
     .make = [](Variant& v) { v.settings.trace.fresnel = v.settings.trace.internal_reflection = false; }},
    {.name = "no_fresnel",
     .title = "glass does not reflect by its angle",
     .expected = "Fresnel's equations share light between the reflected and the refracted ray.",
     .hint = "Is a glass sphere brighter near its rim?",
     .make =
         [](Variant& v) {
           if (v.settings.trace.fresnel) v.settings.trace.internal_reflection = true;
           v.settings.trace.fresnel = false;
         }},
    {.name = "no_bounce",
     .title = "no secondary rays are traced",
     .expected = "Mirrors and glass spawn rays, up to the maximum depth.",
     .hint = "With which depth does the recursion begin?",
     .make = [](Variant& v) { v.settings.trace.max_depth = 0; }},
    {.name = "two_bounces_more",
     .title = "two bounces too many",
     .expected = "Rays are followed for as many bounces as the maximum depth says.",
     .hint = "Where is the depth compared, and where is it counted?",
     .make = [](Variant& v) { v.settings.trace.max_depth += 2; }},
    {.name = "many_bounces",
     .title = "rays are followed without end",
     .expected = "Rays are followed for as many bounces as the maximum depth says.",
     .hint = "What ends the recursion?",
     .make = [](Variant& v) { v.settings.trace.max_depth += 12; }},
    {.name = "mirrors_see_no_background",
     .title = "mirrors and glass see black instead of the background",
     .expected = "A mirror ray that hits nothing sees the background, as a camera ray does.",
     .hint = "What does your recursion return where a ray hits nothing?",
     .make =
         [](Variant& v) {
           Scene& scene = v.OwnScene();
           v.rules.camera_background = scene.background;
           scene.background = {};
         }},
    {.name = "mirror_opposite",
     .title = "mirror rays go the opposite way",
     .expected = "The mirrored direction is d - 2 (d.N) N, with d pointing away from the viewer.",
     .hint = "Does the view vector point to the viewer or away?",
     .make = [](Variant& v) { v.rules.mirror = ShadingRules::Mirror::opposite; }},
    {.name = "mirror_sign",
     .title = "mirror rays have a wrong sign",
     .expected = "The mirrored direction is d - 2 (d.N) N, with d pointing away from the viewer.",
     .hint = "Is there a plus where a minus is due?",
     .make = [](Variant& v) { v.rules.mirror = ShadingRules::Mirror::wrong_sign; }},
    {.name = "mirror_replaces",
     .title = "mirrors blend with the surface's own color",
     .expected = "The color that the mirror ray sees is added; it takes nothing from the other terms.",
     .hint = "Is the local color multiplied by 1 - ks?",
     .make = [](Variant& v) { v.rules.mirror_replaces = true; }},
    {.name = "glass_replaces",
     .title = "glass blends with the surface's own color",
     .expected = "The color seen through a surface is added; it takes nothing from the other terms.",
     .hint = "Is the local color multiplied by 1 - kt?",
     .make = [](Variant& v) { v.rules.glass_replaces = true; }},
    {.name = "transmission_not_weighted",
     .title = "glass transmits all light",
     .expected = "The color seen through a surface is multiplied by its transmittance kt.",
     .hint = "What multiplies the color that the refracted ray returns?",
     .make =
         [](Variant& v) {
           ChangeMaterials(v.OwnScene(), [](Material& m) {
             if (!IsBlack(m.kt)) m.kt = {1, 1, 1};
           });
         }},
    {.name = "total_reflection_added",
     .title = "light that cannot leave glass is reflected",
     .expected = "In this course a ray that cannot be refracted ends.",
     .hint = "What happens where the root in Snell's law has no solution?",
     .make =
         [](Variant& v) {
           if (!v.settings.trace.fresnel) v.settings.trace.internal_reflection = true;
         }},
};

}  // namespace ray::grade

#include "grader/mistakes/Tables.h"

#include <algorithm>

#include "R1/Elementary.h"

namespace ray::grade {

extern const MistakeTable camera_mistakes{
    {.name = "field_of_view_doubled",
     .title = "the field of view is twice as wide",
     .expected = "The angle in the scene file is used as the course defines it: whole or half, horizontal or vertical.",
     .hint = "Is everything half as large?",
     .make =
         [](Variant& v) {
           double& angle = v.OwnScene().camera.xfov;
           angle = std::min(2 * angle, 1.5);
         }},
    {.name = "field_of_view_halved",
     .title = "the field of view is half as wide",
     .expected = "The angle in the scene file is used as the course defines it: whole or half, horizontal or vertical.",
     .hint = "Is everything twice as large?",
     .make = [](Variant& v) { v.OwnScene().camera.xfov /= 2; }},
    {.name = "field_of_view_of_height",
     .title = "the field of view is taken across the other side of the image",
     .expected =
         "The angle is across the width or across the height, as the course says; the other follows from the aspect.",
     .hint = "Try a wide and a tall image of one scene.",
     .make =
         [](Variant& v) {
           double& angle = v.OwnScene().camera.xfov;
           angle = R1::Atan(R1::Tan(angle) * v.settings.width / v.settings.height);
         }},
    {.name = "aspect_ignored",
     .title = "the image is stretched: the aspect ratio is ignored",
     .expected = "Pixels are square: height and width of the image plane are in the proportion of the pixels.",
     .hint = "Are spheres round in an image that is not square?",
     .make = [](Variant& v) { v.OwnScene().camera.aspect = 1; }},
    {.name = "looks_backwards",
     .title = "the camera looks backwards",
     .expected = "The view direction goes from the eye to what is looked at.",
     .hint = "What is behind the camera?",
     .make =
         [](Variant& v) {
           Camera& camera = v.OwnScene().camera;
           camera.towards = -camera.towards;
           camera.right = -camera.right;
         }},
    {.name = "eye_at_origin",
     .title = "the camera is at the origin",
     .expected = "Rays start at the eye.",
     .hint = "Where do your camera rays start?",
     .make = [](Variant& v) { v.OwnScene().camera.eye = {}; }},
};

}  // namespace ray::grade

#include "grader/mistakes/Tables.h"

#include <algorithm>
#include <numbers>

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
    {.name = "field_of_view_in_degrees",
     .title = "the field of view is taken for degrees",
     .expected = "Angles in the scene file are in the units that the course defines.",
     .hint = "Is the angle converted to radians though it is in radians?",
     .make =
         [](Variant& v) {
           double& angle = v.OwnScene().camera.xfov;
           angle *= std::numbers::pi / 180;
         }},
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
    {.name = "aspect_inverted",
     .title = "the aspect ratio is inverted",
     .expected = "Pixels are square: height and width of the image plane are in the proportion of the pixels.",
     .hint = "Is height divided by width, or width by height?",
     .make =
         [](Variant& v) { v.OwnScene().camera.aspect = static_cast<double>(v.settings.height) / v.settings.width; }},
    {.name = "looks_at_direction",
     .title = "the view direction is taken for a point to look at",
     .expected = "The scene file gives the direction of view, not a target.",
     .hint = "Is the eye subtracted from the direction?",
     .make =
         [](Variant& v) {
           Camera& camera = v.OwnScene().camera;
           // The largest component of directions in files is nearly always 1.
           const R3::Vector to = (1 / MaxComponent(Abs(camera.towards))) * camera.towards - (camera.eye - R3::Point{});
           const Camera aimed = Aim(camera.eye, to, camera.up).camera;
           camera.towards = aimed.towards, camera.up = aimed.up, camera.right = aimed.right;
         }},
    {.name = "looks_backwards",
     .title = "the camera looks backwards",
     .expected = "The view direction points from the eye to the target.",
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
    {.name = "angle_without_tangent",
     .title = "the field of view is used without its tangent",
     .expected = "Half the width of the image plane at distance 1 is the tangent of half the angle.",
     .hint = "What is the half width for an angle of 45 degrees?",
     .make =
         [](Variant& v) {
           double& angle = v.OwnScene().camera.xfov;
           angle = R1::Atan(angle);
         }},
    {.name = "aspect_in_whole_numbers",
     .title = "the aspect ratio is computed in whole numbers",
     .expected = "Width divided by height is a fraction: 4 / 3 is not 1.",
     .hint = "Are width and height integers where they are divided?",
     .make =
         [](Variant& v) {
           const int aspect = v.settings.width / v.settings.height;
           if (aspect > 0) v.OwnScene().camera.aspect = aspect;
         }},
    {.name = "up_not_orthogonal",
     .title = "the camera's up vector is used as given in the file",
     .expected = "Up is made orthogonal to the view direction: up = right x towards.",
     .hint = "Are heights wrong where the camera looks down?",
     .make =
         [](Variant& v) {
           Camera& camera = v.OwnScene().camera;
           // Files nearly always have a coordinate axis.
           const R3::Vector a = Abs(camera.up);
           const auto sign = [](double x) { return x < 0 ? -1.0 : 1.0; };
           camera.up = a.y >= a.x && a.y >= a.z ? R3::Vector{0, sign(camera.up.y), 0}
                       : a.z >= a.x             ? R3::Vector{0, 0, sign(camera.up.z)}
                                                : R3::Vector{sign(camera.up.x), 0, 0};
         }},
    {.name = "towards_not_normalized",
     .title = "the view direction is not of unit length",
     .expected = "The view direction is normalized before the image plane is placed at distance 1.",
     .hint = "Does the image change if the direction in the file is doubled?",
     .make =
         [](Variant& v) {
           Camera& camera = v.OwnScene().camera;
           // The largest component of directions in files is nearly always 1.
           camera.xfov = R1::Atan(R1::Tan(camera.xfov) * MaxComponent(Abs(camera.towards)));
         }},
};

}  // namespace ray::grade

#include "grader/mistakes/Tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grader/Changes.h"

namespace ray::grade {

extern const MistakeTable image_mistakes{
    {.name = "gamma",
     .title = "the image is gamma encoded",
     .expected = "This course's bytes are linear: 255 times the value.",
     .hint = "Is a value of 0.5 written as 128?",
     .of_image =
         [](const R2::Image& image) {
           return EachChannel(image, [](double channel) { return R2::EncodeSrgb(std::clamp(channel, 0.0, 1.0)); });
         }},
    {.name = "wrapped",
     .title = "bright values wrap around",
     .expected = "Values above 1 become 255; a byte that is given more starts again at 0.",
     .hint = "Look at the brightest spots: do they have dark holes?",
     .of_image =
         [](const R2::Image& image) {
           return EachChannel(
               image, [](double channel) { return std::fmod(std::floor(255 * std::max(0.0, channel)), 256.0) / 255; });
         }},
    {.name = "upside_down",
     .title = "the image is upside down",
     .expected = "Row 0 is at the top in image files; the image plane's y points up.",
     .hint = "Which way does y grow in your image?",
     .of_image =
         [](const R2::Image& image) {
           return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
             return PixelPlace{x, image.Height() - 1 - y};
           });
         }},
    {.name = "mirrored",
     .title = "the image is mirrored left to right",
     .expected = "Right is the cross product of the view direction and up, in this order; x grows along it.",
     .hint = "In which order is the cross product taken?",
     .of_image =
         [](const R2::Image& image) {
           return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
             return PixelPlace{image.Width() - 1 - x, y};
           });
         }},
    {.name = "half_turn",
     .title = "the image is turned by half a turn",
     .expected = "Seen from the eye, x of the image plane grows to the right, and y upward.",
     .hint = "A pinhole's own image is upside down; the image plane in front of the eye is not.",
     .of_image =
         [](const R2::Image& image) {
           return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
             return PixelPlace{image.Width() - 1 - x, image.Height() - 1 - y};
           });
         }},
    {.name = "transposed",
     .title = "rows and columns are swapped",
     .expected = "A pixel is at row times width plus column.",
     .hint = "Which of two loops is the outer one?",
     .of_image =
         [](const R2::Image& image) {
           return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
             return PixelPlace{(image.Height() - 1 - y) * image.Width() / image.Height(),
                               image.Height() - 1 - x * image.Height() / image.Width()};
           });
         }},
    {.name = "columns_stored",
     .title = "pixels are stored by columns",
     .expected = "A pixel is at row times width plus column.",
     .hint = "Which of two loops is the outer one, and which of the two sizes is a factor?",
     .of_image =
         [](const R2::Image& image) {
           const int width = image.Width(), height = image.Height();
           return Moved(image, width, height, [&](int x, int y) {
             const int place = (height - 1 - y) * width + x;
             return PixelPlace{place / height, height - 1 - place % height};
           });
         }},
    {.name = "red_and_blue_swapped",
     .title = "red and blue are swapped",
     .expected = "Image files hold red, green, blue; some libraries want blue first.",
     .hint = "Render a red sphere.",
     .of_image =
         [](const R2::Image& image) {
           return EachColor(image, [](const R2::Color& c) { return R2::Color{c.b, c.g, c.r}; });
         }},
    {.name = "divided_by_pi",
     .title = "light is divided by pi",
     .expected = "In this course's units a light of color 1 that falls straight on kd 1 gives 1.",
     .hint = "Is everything a third as bright?",
     .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kd = m.kd / std::numbers::pi; }); }},
    {.name = "tone_mapped",
     .title = "the image is tone mapped",
     .expected = "Values are clamped to [0, 1] and nothing else.",
     .hint = "What is written for a value of 1?",
     .of_image =
         [](const R2::Image& image) {
           return EachChannel(image, [](double channel) { return channel / (1 + std::max(0.0, channel)); });
         }},
    {.name = "gray",
     .title = "the image has no colors",
     .expected = "The three channels are computed separately.",
     .hint = "Is one number returned where three are due?",
     .of_image =
         [](const R2::Image& image) {
           return EachColor(image, [](const R2::Color& c) {
             const double gray = (c.r + c.g + c.b) / 3;
             return R2::Color{gray, gray, gray};
           });
         }},
    {.name = "shape_colors_only",
     .title = "surfaces have their plain color, unlit",
     .expected = "I = ka Ia + sum over the lights of (kd (N.L) + ks (V.R)^n) IL.",
     .hint = "Is the color of a hit that of its material, whatever the lights?",
     .make = [](Variant& v) { v.settings.mode = RenderMode::flat; }},
    {.name = "normals_shown",
     .title = "normals are shown as colors",
     .expected = "I = ka Ia + sum over the lights of (kd (N.L) + ks (V.R)^n) IL.",
     .hint = "Was a test of the normals left in the program?",
     .make = [](Variant& v) { v.settings.mode = RenderMode::normal_color; }},
    {.name = "clamped_by_largest",
     .title = "bright colors are scaled instead of clamped",
     .expected = "Each channel is clamped to [0, 1] by itself.",
     .hint = "Does a bright spot keep its hue?",
     .of_image =
         [](const R2::Image& image) {
           return EachColor(image, [](const R2::Color& c) { return c / std::max({1.0, c.r, c.g, c.b}); });
         }},
};

}  // namespace ray::grade

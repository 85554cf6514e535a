#pragma once

#include <string>

#include "R2/Image.h"

/// Parts of pages that are one file each: without scripts or external resources.
namespace ray::grade {

/// Escapes text for HTML.
std::string HtmlOf(const std::string& text);
/// Returns an image element that contains the image as a PNG; pixels stay sharp when they are enlarged.
///   about   a description for those who cannot see it
std::string ImageTag(const R2::Image& image, const std::string& about);
/// Returns two images of the same size, the first over the left half of the second, up to an edge that can be dragged;
/// one below the other in print.
std::string Slider(const R2::Image& over, const std::string& about_over, const R2::Image& under,
                   const std::string& about_under);
/// Returns a whole page.
std::string Page(const std::string& title, const std::string& body);
/// Returns a part of an image around a pixel, which is marked, enlarged by `scale`.
R2::Image CropAround(const R2::Image& image, int x, int y, int reach, int scale);

}  // namespace ray::grade

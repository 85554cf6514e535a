#pragma once

#include <string>

#include "R2/Image.h"

/// Pieces of pages that are one file each: no script, nothing loaded from elsewhere.
namespace ray::grade {

/// Text as a page holds it.
std::string HtmlOf(const std::string& text);
/// The image itself, as a PNG within the page; pixels stay sharp when they are enlarged.
///   about   in words, for those who cannot see it
std::string ImageTag(const R2::Image& image, const std::string& about);
/// Two images of one size, the first over the left half of the second, up to an edge that can be dragged; one below the
/// other in print.
std::string Slider(const R2::Image& over, const std::string& about_over, const R2::Image& under,
                   const std::string& about_under);
/// A whole page.
std::string Page(const std::string& title, const std::string& body);
/// A part of an image around a pixel, marked, so many times as large.
R2::Image CropAround(const R2::Image& image, int x, int y, int reach, int scale);

}  // namespace ray::grade

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
/// A whole page.
std::string Page(const std::string& title, const std::string& body);
/// A part of an image around a pixel, marked, so many times as large.
R2::Image CropAround(const R2::Image& image, int x, int y, int reach, int scale);

}  // namespace ray::grade

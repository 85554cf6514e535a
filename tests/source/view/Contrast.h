#pragma once

#include <algorithm>
#include <cmath>

#include "source/draw/Drawing.h"

/// Contrast of colors on a screen.
///   source   W3C, Web Content Accessibility Guidelines 2.1, contrast ratio and relative luminance
namespace ray::contrast {

inline constexpr double of_text = 4.5, of_marks = 3;  // the least of level AA (1.4.3 and 1.4.11)

/// From 0 to 1 each.
struct Color {
  double r = 0, g = 0, b = 0;
};

inline Color AsColor(const Rgba& c) { return {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0}; }

/// `color`, of which the share `alpha` is seen, over `ground`.
inline Color Over(const Color& color, double alpha, const Color& ground) {
  const auto mix = [&](double a, double b) { return alpha * a + (1 - alpha) * b; };
  return {mix(color.r, ground.r), mix(color.g, ground.g), mix(color.b, ground.b)};
}

inline double Luminance(const Color& color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

inline double Between(const Color& a, const Color& b) {
  const double la = Luminance(a), lb = Luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace ray::contrast

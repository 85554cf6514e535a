#pragma once

#include <bit>
#include <cstdint>

namespace R2 {

/// Linear red, green and blue, unbounded, in the scene's own light units.
struct Color {
  double r = 0, g = 0, b = 0;

  Color& operator+=(const Color& o) {
    r += o.r, g += o.g, b += o.b;
    return *this;
  }
  friend bool operator==(const Color&, const Color&) = default;
};

inline Color operator+(Color a, const Color& b) { return a += b; }
inline Color operator-(const Color& a, const Color& b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
inline Color operator*(const Color& a, const Color& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
inline Color operator*(double s, const Color& c) { return {s * c.r, s * c.g, s * c.b}; }
inline Color operator*(const Color& c, double s) { return s * c; }
inline Color operator/(const Color& c, double s) { return {c.r / s, c.g / s, c.b / s}; }

inline bool IsBlack(const Color& c) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return (bits(c.r) | bits(c.g) | bits(c.b)) << 1 == 0;  // ignores signs; avoids a branch per channel
}

/// The course's luminance weights (specified with the .scn language; they sum to one).
inline double Luminance(const Color& c) { return 0.30 * c.r + 0.59 * c.g + 0.11 * c.b; }

/// Returns the channel as a screen with the range 0 to 1 shows it; NaN becomes 0.
inline double Clamped(double channel) { return channel > 0 ? (channel < 1 ? channel : 1) : 0; }

inline Color Clamped(const Color& c) { return {Clamped(c.r), Clamped(c.g), Clamped(c.b)}; }

/// Encodes one linear channel with the exact sRGB curve (IEC 61966-2-1); values below 0 stay linear.
double EncodeSrgb(double linear);
/// Decodes one channel, the inverse of EncodeSrgb.
double DecodeSrgb(double encoded);

Color EncodeSrgb(const Color& linear);
Color DecodeSrgb(const Color& encoded);

}  // namespace R2

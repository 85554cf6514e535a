#include "R2/Color.h"

#include "R1/Elementary.h"

namespace R2 {

double EncodeSrgb(double linear) {
  return linear > 0.0031308 ? 1.055 * R1::Pow(linear, 1 / 2.4) - 0.055 : 12.92 * linear;
}

double DecodeSrgb(double encoded) {
  return encoded > 0.04045 ? R1::Pow((encoded + 0.055) / 1.055, 2.4) : encoded / 12.92;
}

Color EncodeSrgb(const Color& c) { return {EncodeSrgb(c.r), EncodeSrgb(c.g), EncodeSrgb(c.b)}; }
Color DecodeSrgb(const Color& c) { return {DecodeSrgb(c.r), DecodeSrgb(c.g), DecodeSrgb(c.b)}; }

}  // namespace R2

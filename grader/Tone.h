#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "R2/Image.h"

namespace ray::grade {

/// A simple change of a whole image: out[i] = offset[i] + factor[i] in[order[i]]^exponent. Any difference is explained
/// by the best of these first, so that no mistake is named for what is only an exposure.
struct Tone {
  std::string name;   // "scaled": for tables
  std::string title;  // completes "as with"
  std::string hint;   // where to look
  std::array<double, 3> factor{1, 1, 1}, offset{0, 0, 0};
  std::array<int, 3> order{0, 1, 2};  // of channels
  double exponent = 1;
  bool before_clamping = false;  // else of the values for a screen, 0 to 1
  int free_numbers = 1;          // that were fitted; of equally good ones the simplest counts
};

/// Values for a screen.
///   light   before it is clamped
R2::Image Toned(const R2::Image& light, const Tone& tone);

/// An image that was handed in, the image that it should be, before it is clamped, and the pixels that count.
struct TonePair {
  const R2::Image& image;
  const R2::Image& light;
  const std::vector<bool>& counts;
};

/// The simple changes that fit best, each by least squares over all pairs together.
std::vector<Tone> FittedTones(std::span<const TonePair> pairs);

/// How a program may encode the bytes of its image: all are common, none is a mistake of tracing.
enum class Encoding { linear, srgb, power };  // the last of 1 / 2.2
R2::Image Encoded(const R2::Image& image, Encoding encoding);
R2::Image Decoded(const R2::Image& image, Encoding encoding);

}  // namespace ray::grade

#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "R2/Image.h"

namespace ray::grade {

/// A simple change of a whole image: out[i] = offset[i] + factor[i] in[order[i]]^exponent. The best of these explains
/// any difference first, so that no mistake is named for a mere exposure.
struct Tone {
  std::string name;   // for tables: "scaled"
  std::string title;  // completes "as with"
  std::string hint;   // a suggestion where to look
  std::array<double, 3> factor{1, 1, 1}, offset{0, 0, 0};
  std::array<int, 3> order{0, 1, 2};  // of channels
  double exponent = 1;
  bool before_clamping = false;  // otherwise of displayed values, 0 to 1
  int free_numbers = 1;          // number of fitted values; of equally good changes the simplest counts
};

/// Applies a change, and returns displayed values.
///   light   before it is clamped
R2::Image Toned(const R2::Image& light, const Tone& tone);

/// A submitted image, the expected one before it is clamped, and the pixels that count.
struct TonePair {
  const R2::Image& image;
  const R2::Image& light;
  const std::vector<bool>& counts;
};

/// Returns the simple changes that fit best, each by least squares over all pairs together.
std::vector<Tone> FittedTones(std::span<const TonePair> pairs);

/// The encoding of an image's bytes: all are common, none is a mistake of tracing.
enum class Encoding { linear, srgb, power };  // power: 1 / 2.2
R2::Image Encoded(const R2::Image& image, Encoding encoding);
R2::Image Decoded(const R2::Image& image, Encoding encoding);

}  // namespace ray::grade

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "R2/Plane.h"
#include "R2/compare/Difference.h"
#include "rayimg/Options.h"

namespace ray::rayimg {

/// All measurements of rayimg diff for two images.
struct Findings {
  R2::Difference difference;
  double flip = 0;
  std::optional<double> product;              // mean (x - r1)(x - r2), with a second reference
  std::optional<std::int64_t> pixels_beyond;  // with -fail
  std::vector<std::string> failures;          // why the images differ by more than allowed

  double PercentBeyond() const {
    return 100 * static_cast<double>(pixels_beyond.value_or(0)) / static_cast<double>(difference.pixels);
  }
};

struct Measurement {
  Findings found;
  R2::Plane flip_map;
};

/// Returns the conversion for display that -srgb selects.
R2::Display DisplayOf(const ImageOptions& options);

/// Measures two images of the same size. The caller adds the product.
Measurement Measure(const R2::Image& x, const R2::Image& r, const ImageOptions& options);

/// Returns "r", "g" or "b".
const char* ChannelName(int channel);
/// Returns the square root; std::nullopt for a negative number, where the error is below the remaining noise.
std::optional<double> Root(double product);

/// Returns an object with a key for each measure. Numbers that JSON cannot represent become null.
nlohmann::ordered_json JsonOf(const Findings& found, const std::string& reference2);

}  // namespace ray::rayimg

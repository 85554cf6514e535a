#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "R2/Plane.h"
#include "R2/compare/Difference.h"
#include "source/rayimg/Options.h"

namespace ray::rayimg {

/// Everything that rayimg diff measures of two pictures.
struct Findings {
  R2::Difference difference;
  double flip = 0;
  std::optional<double> product;              // mean (x - r1)(x - r2), with a second reference
  std::optional<std::int64_t> pixels_beyond;  // with -fail
  std::vector<std::string> failures;          // why the pictures differ by more than is allowed

  double PercentBeyond() const {
    return 100 * static_cast<double>(pixels_beyond.value_or(0)) / static_cast<double>(difference.pixels);
  }
};

struct Measurement {
  Findings found;
  R2::Plane flip_map;
};

/// How values are shown: as -srgb asks.
R2::Display DisplayOf(const ImageOptions& options);

/// Both of one size. The product is left to the caller.
Measurement Measure(const R2::Image& x, const R2::Image& r, const ImageOptions& options);

/// "r", "g" or "b".
const char* ChannelName(int channel);
/// No root of a negative number: then there is less error than the noise that is left.
std::optional<double> Root(double product);

/// A key for each measure. Numbers that JSON cannot hold become null.
nlohmann::ordered_json JsonOf(const Findings& found, const std::string& reference2);

}  // namespace ray::rayimg

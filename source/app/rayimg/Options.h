#pragma once

#include <optional>
#include <string>
#include <vector>

#include "R2/compare/Flip.h"

namespace ray::rayimg {

/// Everything that the command line of rayimg decides. Names, ranges and help are in Table.cpp; the defaults are here.
struct Options {
  std::vector<std::string> names;  // of files, as typed

  // light and files
  bool srgb = false;
  double exposure = 0;  // stops
  std::string tonemap = "none";
  std::string bits = "8";
  int jpeg_quality = 95;
  std::string out;

  // comparison
  std::string reference2, map, map_of = "flip";
  double pixels_per_degree = R2::flip_pixels_per_degree;
  std::optional<double> fail, fail_percent, fail_rmse, fail_flip;
  bool json = false;

  // merging
  std::vector<double> weights;
  bool force = false;

  // movies
  double fps = 25;
};

}  // namespace ray::rayimg

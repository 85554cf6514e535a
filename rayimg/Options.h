#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "R2/compare/Flip.h"
#include "source/app/options/Options.h"
#include "source/film/Filter.h"
#include "source/film/PixelRectangle.h"

namespace ray::rayimg {

/// The content of a heat map of a difference.
enum class MapOf { flip, display };
inline constexpr std::array map_names{"flip", "display"};
constexpr const auto& NamesOf(MapOf) { return map_names; }

/// The options of rayimg's commands. Names, ranges and help are in Table.cpp; the defaults are here.
struct ImageOptions : Options {
  ImageOptions() : Options(Program::rayimg) {}

  // light and files
  bool srgb = false;
  double exposure = 0;  // stops
  std::string tonemap = "none";
  int bits = 8;
  int jpeg_quality = 95;
  std::string out;

  // comparison
  std::string reference2, map;
  MapOf map_of = MapOf::flip;
  double pixels_per_degree = R2::flip_pixels_per_degree;
  std::optional<double> fail, fail_percent, fail_rmse, fail_flip;
  bool json = false;
  std::string html, csv;  // files to write

  // arranging
  std::optional<int> width, height;  // pixels
  FilterKind filter = FilterKind::box;
  std::optional<PixelRectangle> crop;
  std::optional<int> columns;
  std::optional<int> gap;             // pixels between images
  std::vector<std::string> captions;  // one per image
  bool captions_are_names = false;

  // merging
  std::vector<double> weights;
  bool force = false;

  // movies
  double fps = 25;
};

}  // namespace ray::rayimg

#pragma once

#include <string>

#include "R3/Vector.h"

namespace ray::comp30019 {

/// What the options of COMP30019's command line set, with their defaults.
struct Asked {
  std::string file, output;
  int width = 400, height = 400, samples_a_side = 1, quality = 0;
  bool ambient = false, one_sided = false;
  R3::Vector position{0, 0, 0}, axis{0, 0, 1};
  double angle = 0, aperture = 0, focus = 1;  // the angle in degrees
};

}  // namespace ray::comp30019

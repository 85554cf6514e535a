#pragma once

#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// What an accelerator costs to build, to keep, and per ray of a picture.
struct AcceleratorCost {
  std::string name;
  double build_seconds = 0, render_seconds = 0;  // of a small picture, on one thread
  std::size_t bytes = 0;                         // besides the world's own
  double boxes = 0, tests = 0;                   // per ray: boxes, nodes and cells; primitives
};

/// Builds every kind of accelerators.def but `auto`, and renders with it the picture of the settings at one sample per
/// pixel, made so small that trying every primitive for every ray takes seconds at most. Numbers per ray are the same
/// every time, seconds are this machine's.
std::vector<AcceleratorCost> CostsOfAccelerators(const World& world, const AcceleratorSettings& how,
                                                 const RenderSettings& settings);

}  // namespace ray

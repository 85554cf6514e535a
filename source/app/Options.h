#pragma once

#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/accelerate/AcceleratorSettings.h"
#include "source/parse/Parse.h"
#include "source/render/Render.h"

namespace ray {

/// What the program is asked to do.
enum class Task { render, check, info, help, version, list, complete, manual };

/// Everything the command line decides. Ranges, units and help are in the option table; the defaults are here.
struct Options {
  std::string scene, picture;  // as typed; empty where the task needs none

  RenderSettings render;
  AcceleratorSettings accelerator;
  ParseOptions parse;
  R2::ImageEncoding encoding;

  bool quiet = false, verbose = false, stats = false, explain = false;
  std::string report;  // file name; empty for no report

  std::string quality = "custom";      // a row of the presets, or none of them
  std::vector<std::string> reference;  // at most two files
  std::vector<std::string> layers;     // of layer_names, beside the picture
  double checkpoint = 0;               // seconds between two; 0: only when a signal ends the run
  bool resume = false;
  std::string replay;  // file name of a report; empty for none

  Task task = Task::render;
  std::string subject;  // of help, list, complete and info
};

}  // namespace ray

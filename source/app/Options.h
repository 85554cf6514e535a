#pragma once

#include <string>

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

  Task task = Task::render;
  std::string subject;  // of help, list, complete and info
};

}  // namespace ray

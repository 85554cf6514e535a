#pragma once

#include <optional>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/accelerate/AcceleratorSettings.h"
#include "source/app/options/Options.h"
#include "source/parse/Parse.h"
#include "source/render/Layer.h"
#include "source/render/Render.h"

namespace ray {

/// The files that a render reads and writes, as typed; empty for none.
struct FileOptions {
  std::string scene, picture;          // empty where the task needs none, or where rayview is to choose a name
  std::vector<std::string> reference;  // at most two files
  std::vector<Layer> layers;           // beside the picture
  std::string report;
  std::string replay;  // a report
};

/// When the state of a render is saved, and what becomes of it.
struct CheckpointOptions {
  double seconds = 0;  // between two; 0: only when a signal ends the run
  bool resume = false, restart = false, keep = false;
};

/// What raypro and rayview are asked. Ranges, units and help are in the option table; the defaults are here.
struct RenderOptions : Options {
  explicit RenderOptions(const Program& which = Program::raypro) : Options(which) {}

  bool as_course = false;                      // typed in the words of a course, which say more than ours could
  std::vector<std::string> scenes;             // as typed, of a command that renders each into out_folder; else empty
  std::string out_folder, out_format = "png";  // an extension

  FileOptions files;
  CheckpointOptions checkpoint;
  RenderSettings render;
  AcceleratorSettings accelerator;
  ParseOptions parse;
  R2::ImageEncoding encoding;

  bool quiet = false, verbose = false, stats = false, explain = false;
  bool keep_times = false;  // in the image
  double memory = 0;        // GiB that the program may take; 0: three quarters of the machine's

  std::string quality = "custom";  // a row of the presets, or none of them
  std::string parts;               // a pattern of file names, to assemble; empty for none
  int missing = 0;                 // of so many parts, those that are not rendered are printed; 0: render
  std::optional<Pixel> pixel;      // of -debugpixel
};

}  // namespace ray

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
  std::string scene, image;            // empty if not needed, or if rayview is to choose a name
  std::vector<std::string> reference;  // at most two files
  std::vector<Layer> layers;           // in addition to the image
  std::string report;
  std::string replay;  // a report
};

/// The schedule for saving the state of a render, and whether it is kept.
struct CheckpointOptions {
  double seconds = 0;  // between checkpoints; 0: only if a signal ends the run
  bool resume = false, restart = false, keep = false;
};

/// The size of an image if neither the scene nor the command line chooses it, and its samples. If only a side of it is
/// chosen, the other one and the samples have the course's defaults, those of RenderSettings: 256 pixels, one sample.
struct DefaultImage {
  int side = 1024;                   // of the square, pixels
  int samples = 16;                  // per pixel, unless they are chosen, or a budget
  int samples_of_a_chosen_size = 1;  // likewise, if the scene or the command line chooses the size
  bool has_its_samples = false;      // neither scene nor options choose the samples
};

/// The options of raypro and rayview. Ranges, units and help are in the option table; the defaults are here.
struct RenderOptions : Options {
  explicit RenderOptions(const Program& which = Program::raypro) : Options(which) {}

  bool as_course = false;                      // typed in the language of a course, which can express more than ours
  std::vector<std::string> scenes;             // as typed, if each is rendered into out_folder; otherwise empty
  std::string out_folder, out_format = "png";  // an extension

  FileOptions files;
  CheckpointOptions checkpoint;
  RenderSettings render;
  DefaultImage default_image;
  AcceleratorSettings accelerator;
  ParseOptions parse;
  R2::ImageEncoding encoding;

  bool quiet = false, verbose = false, stats = false, explain = false;
  bool keep_times = false;  // in the image
  double memory = 0;        // GiB that the program may use; 0: three quarters of the machine's

  std::string quality = "custom";  // the name of a preset, or "custom"
  std::string parts;               // a pattern of file names to assemble; empty for none
  int missing = 0;                 // number of parts of which the missing ones are printed; 0: render
  std::optional<Pixel> pixel;      // of -debugpixel
};

}  // namespace ray

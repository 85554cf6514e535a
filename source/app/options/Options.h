#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/accelerate/AcceleratorSettings.h"
#include "source/app/options/Comp30019Asked.h"
#include "source/app/options/Program.h"
#include "grader/Options.h"
#include "source/app/rayimg/Options.h"
#include "source/parse/Parse.h"
#include "source/render/Layer.h"
#include "source/render/Render.h"

namespace ray {

struct CommandKind;
struct OptionKind;

/// What the program is asked to do; `render` is what raypro is for, `view` what rayview is for, `command` what rayimg
/// is, `grade` what raygrade is.
enum class Task {
  render,
  view,
  command,
  grade,
  as_course,
  check,
  files,
  advise,
  convert,
  debug_pixel,
  info,
  help,
  version,
  list,
  complete,
  manual
};

/// A place in a picture.
struct Pixel {
  int x = 0, y = 0;  // column from the left, row from the bottom
};

/// What only rayview is asked. Names of files are as typed; empty for none.
struct ViewOptions {
  std::string output_image;  // gets what the window shows when the program ends
  bool exit_immediately = false;
  bool headless = false;
  std::string context = "auto";  // what headless draws with, one of context_names
  std::string events;            // a script; "-" is standard input
  std::string screenshot;        // gets the drawing after the last event
  std::string record;            // gets what happens, as a script
  std::string reference;         // picture to compare with
  std::string panels = "off";    // from the start, one of panel_themes
};
inline constexpr std::array panel_themes{"off", "dark", "light"};
inline constexpr std::array context_names{"auto", "egl", "osmesa"};

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

/// Everything the command line decides. Ranges, units and help are in the option table; the defaults are here.
struct Options {
  Program program = Program::raypro;
  std::vector<std::string> given;              // the options that were typed, by name and without the dash
  bool as_course = false;                      // typed in the words of a course, which say more than ours could
  std::vector<std::string> scenes;             // as typed, of a command that renders each into out_folder; else empty
  std::string out_folder, out_format = "png";  // an extension

  FileOptions files;
  CheckpointOptions checkpoint;
  RenderSettings render;
  AcceleratorSettings accelerator;
  ParseOptions parse;
  R2::ImageEncoding encoding;
  ViewOptions view;
  const CommandKind* command = nullptr;  // of a program that has commands
  rayimg::ImageOptions image;
  raygrade::GradeOptions grade;
  comp30019::Asked course;  // only while that course's command line is read

  bool quiet = false, verbose = false, stats = false, explain = false;
  bool keep_times = false;  // in the picture
  double memory = 0;        // GiB that the program may take; 0: three quarters of the machine's

  std::string quality = "custom";  // a row of the presets, or none of them
  std::string parts;               // a pattern of file names, to assemble; empty for none
  int missing = 0;                 // of so many parts, those that are not rendered are printed; 0: render

  Task task = Task::render;
  std::string subject;         // of help, list, complete, info and manual; of convert the file to write
  std::optional<Pixel> pixel;  // of debug_pixel

  bool IsGiven(const std::string& option) const { return std::ranges::find(given, option) != given.end(); }
  /// The value in force, as it would be typed; empty when there is none.
  std::string Show(const OptionKind& option) const;
  /// The words that ask a program for the value in force: "-motion", "0", "1", "0". None when there is no value, or
  /// when it is the program's default and was not typed; what was typed may be the default, and a scene state another
  /// value.
  std::vector<std::string> TypedFor(Program reader, const OptionKind& option) const;
  /// Ends the sentence that begins with "-focus has no effect": "without -aperture and -sampler grid". Empty where the
  /// option has an effect.
  std::string WhyWithoutEffect(const OptionKind& option) const;
};

/// What a program does unless told otherwise.
Options Defaults(Program program);

}  // namespace ray

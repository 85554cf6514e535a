#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/app/options/RenderOptions.h"
#include "source/integrate/RayCounts.h"
#include "source/render/Render.h"

namespace ray {

/// Everything about a run that is written to the image, a report or the terminal: the results of its render, and more.
struct RunStats : RenderSummary {
  RenderOptions options;
  std::string command;  // as typed
  std::string image_file;  // the file that was written

  struct {
    std::string hash;
    std::vector<std::string> settings;  // the scene's own settings in force: "-max_depth 2 (room.scn:12:3)"
    std::int64_t nodes = 0, instances = 0, primitives = 0, lights = 0;
  } scene;

  std::string accelerator;               // the kind that was built
  std::size_t structure_bytes = 0;
  struct {
    double load = 0, build = 0, render = 0, write = 0, wall = 0, cpu = 0;
    double shared = 0;  // since machines began this image together; 0 if no clock counts it
  } seconds;
  std::int64_t peak_memory = 0;  // bytes
  int threads = 1;               // that are used
  int width = 0, height = 0;     // of the written image
  std::vector<std::string> warnings;
  std::string stopped_by = "samples";  // samples, time, error, or the name of a signal
  std::optional<double> true_error;    // in the unit of `error`, with -reference
  std::vector<std::string> needs, biased;
  std::string kernel;

  /// Copies the results of a render.
  void Take(const RenderResult& result);
};

/// Returns the number of threads that render.
int ThreadsOf(const RenderSettings& settings);

/// Returns "raypro scene.scn image.jpg -width 512". Paths are as the user typed them, and the program is a bare name,
/// since the shell may have found it anywhere.
std::string CommandAsTyped(std::span<const std::string> words);

/// Returns the metadata stored in the image. It depends on the options alone, not on the day or the machine, unless
/// -keep_times is given.
R2::ImageSettings SettingsInImage(const RunStats& stats);

/// Returns the settings in force that cut off light: "-max_depth 3, -min_luminance 0.01".
std::string LimitsOfLight(const RunStats& stats);

/// Returns "out.jpg 512x512 16 spp 1.83 s 14.2 Mrays/s".
std::string FinalLine(const RunStats& stats);

/// Returns the image's error, as far as it is known, and why the render ended, if there is a budget or a reference;
/// otherwise an empty text.
std::string QualityLines(const RunStats& stats);

/// Returns the text of -stats.
std::string Statistics(const RunStats& stats);

}  // namespace ray

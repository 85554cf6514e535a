#include "source/app/report/ReportFields.h"

namespace ray {

std::span<const ReportField> ReportFields() {
  static constexpr ReportField fields[] = {
      {"version", "version of the program, such as \"0.1.0\""},
      {"command", "the command as typed"},
      {"scene", "file (as typed), hash (of all files it was read from), nodes, instances, primitives, lights"},
      {"settings",
       "every option in force by its name: numbers, true or false, names; crop is [x0, y0, x1, y1] or null, "
       "allow_path a list"},
      {"rays",
       "number of camera, shadow, reflection, transmission and diffuse rays; cut (wanted, but over the limit"
       " of a camera ray); caustics (paths that found the brightest light by way of mirrors or glass); total"
       " (all but cut); guides (rays of -denoise, which total includes); refining (most, and samples per "
       "pixel, of the guides' own camera rays; null without a time limit); costs (the counts of each kind)"},
      {"counts", "node_visits, box_tests, primitive_tests, hits, cache_tests, cache_hits, bad_rays"},
      {"accelerator", "the structure that was built; settings.accel is the requested one"},
      {"structure_bytes", "memory of the structure, besides the scene"},
      {"seconds",
       "load, build, render, denoise (a part of render), guides (a part of denoise), write, wall (from the "
       "start of the program to the report), cpu (of all threads)"},
      {"peak_memory_bytes", "the maximum memory of the process"},
      {"threads", "number of threads that rendered"},
      {"pixels", "done, total"},
      {"warnings", "lines printed to standard error"},
      {"stop",
       "reason (\"samples\", \"time\", \"error\", \"stall\", or a signal such as \"SIGINT\"), confidence, and "
       "the requested seconds and error (target, unit), or null"},
      {"features_required", "names of the features that scene and settings require"},
      {"kernel", "the innermost loops that ran"},
      {"quality", "the preset, or \"custom\""},
      {"biased", "settings in force that change the expected image"},
      {"share_cut", "estimated fraction of the light, 0 to 1, that -max_depth and -min_luminance cut off"},
      {"samples",
       "least, most and mean per pixel; two_streams; planned_samples (what strata and camera rays are laid "
       "out for); of_blocks (per pixel and stream, of each block of 8x8 pixels in rows from the bottom; "
       "empty if all are equal); places_of_blocks (of blocks without samples, how many of their 64 places"
       " were traced; empty if all have samples)"},
      {"error",
       "estimate, low, high, unit; method (\"two streams\": unbiased; \"two streams, denoised\"; \"halves\":"
       " an upper bound); worst_block (error, at); freedom (degrees of freedom); outlier_share; unseen_share"
       " (fraction of the square of high that is for caustics no path has found); true_error where there is "
       "a reference; before_denoising and denoised_by where it was denoised; null below two samples"},
      {"passes",
       "for each pass: end (samples per pixel and stream), samples (mean per pixel), seconds (since the "
       "first ray), error (left by the filter with -denoise and -error; or null)"},
  };
  return fields;
}

}  // namespace ray

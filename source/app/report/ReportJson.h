#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "source/app/report/RunStats.h"

namespace ray {

/// What -report writes, one JSON object:
///
///   | key                | value                                                                       |
///   |--------------------|-----------------------------------------------------------------------------|
///   | version            | of the program, "0.1.0"                                                     |
///   | command            | as typed                                                                    |
///   | scene              | file (as typed), hash (of the files it was read from), nodes, instances,    |
///   |                    | primitives, lights                                                          |
///   | settings           | every option in force by its name: numbers, true/false, names; crop is      |
///   |                    | [x0, y0, x1, y1] or null, allow_path a list                                 |
///   | rays               | camera, shadow, reflection, transmission, diffuse, cut (wanted but over     |
///   |                    | a camera ray's limit), caustics (paths that found the brightest light by    |
///   |                    | way of mirrors or glass), total (all but cut), guides (of those, what -denoise |
///   |                    | took), refining (of other camera rays than the samples' own: most, samples |
///   |                    | (of a pixel); null without a clock), costs (the counts of each kind)        |
///   | counts             | node_visits, box_tests, primitive_tests, hits, cache_tests, cache_hits,     |
///   |                    | bad_rays                                                                    |
///   | accelerator        | the kind that was built; settings.accel says which was asked for            |
///   | structure_bytes    | what the accelerator takes besides the scene                                |
///   | seconds            | load, build, render, denoise (a part of render), guides (a part of denoise: |
///   |                    | gathering them), write (the picture), wall (from the program's start to     |
///   |                    | this report), cpu (all threads)                                             |
///   | peak_memory_bytes  | the most the process ever held                                              |
///   | threads            | how many worked                                                             |
///   | pixels             | done, total                                                                 |
///   | warnings           | the lines that went to standard error                                       |
///   | stop               | reason ("samples", "time", "error", "SIGINT", "SIGTERM"), confidence,       |
///   |                    | seconds and error (target, unit) asked for, or null                         |
///   | features_required  | what the scene and the settings ask for, in words                           |
///   | kernel             | what ran in the innermost loops                                             |
///   | quality            | the preset, or "custom"                                                     |
///   | biased             | settings in force that move the mean of the picture                         |
///   | share_cut          | by how much it is too dark, about, for what max_depth and min_luminance cut |
///   |                    | off, 0 to 1                                                                 |
///   | samples            | least, most, mean (a pixel), two_streams, planned_samples (how many strata     |
///   |                    | and camera rays were told to expect), of_blocks (a pixel and stream of each |
///   |                    | block of 8x8 pixels, in rows from the bottom; empty when all are alike),    |
///   |                    | places_of_blocks (where a block has no samples, how many of its 64 places   |
///   |                    | were looked at; empty where all have)                                       |
///   | error              | estimate, low, high, unit, method ("two streams": true on average, with     |
///   |                    | ", denoised": of the picture that was denoised; "halves": at most about),   |
///   |                    | worst_block (error, at), freedom (the degrees of freedom that hold it),     |
///   |                    | outlier_share, unseen_share (of the square of high, for caustics that no    |
///   |                    | path has found), true_error beside a reference, and                         |
///   |                    | before_denoising (an estimate), denoised_by (filters and their version);    |
///   |                    | null below two samples                                                      |
///   | passes             | of each: end (samples a pixel and stream), samples (mean a pixel), seconds  |
///   |                    | (since the first ray), error (or null): the render's own convergence        |
std::string ReportJson(const RunStats& record);

/// The part of it called settings.
nlohmann::ordered_json SettingsJson(const Options& options);

}  // namespace ray

#pragma once

#include <string>

#include "source/app/Record.h"

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
///   | rays               | camera, shadow, reflection, transmission, cut (wanted but beyond the limit  |
///   |                    | of one camera ray), total (all but cut), costs (the counts of each kind)    |
///   | counts             | node_visits, box_tests, primitive_tests, hits, cache_tests, cache_hits,     |
///   |                    | bad_rays                                                                    |
///   | structure_bytes    | what the accelerator takes besides the scene                                |
///   | seconds            | load, build, render, write (the picture), wall (from the program's start to |
///   |                    | this report), cpu (all threads)                                             |
///   | peak_memory_bytes  | the most the process ever held                                              |
///   | threads            | how many worked                                                             |
///   | pixels             | done, total                                                                 |
///   | warnings           | the lines that went to standard error                                       |
///   | stop               | "complete", "SIGINT" or "SIGTERM"                                           |
std::string ReportJson(const Record& record);

}  // namespace ray

#pragma once

#include <string>

#include "source/view/live/RenderJob.h"

namespace ray {

/// How far a job has come, in a line: "4 of 16 samples 31 % 0.5 Mrays/s 12 s left", "8 samples until stopped 0.5
/// Mrays/s"; what a budget led to is told by ClaimOf.
std::string StatusOf(const RenderJob& job);

/// What is known of the picture of a job that is complete: "estimated error 1.8/255 (1.7 to 1.9), 64 samples".
std::string ClaimOf(const RenderResult& result);

}  // namespace ray

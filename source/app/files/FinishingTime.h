#pragma once

#include "source/app/files/Outputs.h"

namespace ray {

/// About how many seconds it takes from the last sample to the finished file where few pixels have a sample, and what
/// is filled between them is smooth. As this machine is now, by encoding a small picture, which takes some
/// milliseconds.
double FinishingTimeOf(const R2::ImageFormat& format, const Options& options);

/// The budget of a render with a time limit, which knows how long finishing and filtering take here. Throws
/// DenoiserError.
Budget BudgetWithFinish(const Options& options);

}  // namespace ray

#pragma once

#include "source/app/files/Outputs.h"

namespace ray {

/// About how many seconds it takes from the last sample to the finished file: as this machine is now, by encoding a
/// small picture of noise, which takes a millisecond or two.
double SecondsToFinish(const R2::ImageFormat& format, const Options& options);

}  // namespace ray

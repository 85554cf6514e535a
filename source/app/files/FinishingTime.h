#pragma once

#include "source/app/files/Outputs.h"

namespace ray {

/// About how many seconds it takes from the last sample to the finished file.
struct FinishingTime {
  double least = 0;  // where hardly a pixel has a sample, and what is filled between them is smooth
  double most = 0;   // where all is noise
};

/// As this machine is now, by encoding small pictures, which takes some ten milliseconds.
FinishingTime FinishingTimeOf(const R2::ImageFormat& format, const Options& options);

}  // namespace ray

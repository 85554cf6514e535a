#pragma once

// What Highway compiles kernels for, before anything includes Highway: all but SSSE3, which only processors from before
// 2009 have as their best, and SVE of AArch64, whose vectors have no size that a structure could hold. The first run
// the scalar kernels, the others those of NEON.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

#include <hwy/targets.h>

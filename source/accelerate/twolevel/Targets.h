#pragma once

// What Highway compiles kernels for, before anything includes Highway: all but SSSE3, which only processors from before
// 2009 have as their best. Those run the scalar kernels.
#define HWY_DISABLED_TARGETS HWY_SSSE3

#include <hwy/targets.h>

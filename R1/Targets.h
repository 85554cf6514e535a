#pragma once

// Selects the targets that Highway compiles kernels for; must precede every include of Highway. Excluded are SSSE3,
// which is the best target only of processors from before 2009, and SVE of AArch64, whose vectors have no fixed size
// that a structure could contain. SSSE3 processors run the scalar kernels, SVE processors those of NEON.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

#include <hwy/targets.h>

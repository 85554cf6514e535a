#pragma once

#include "source/app/Options.h"

namespace ray {

/// Does everything the program does besides rendering: prints its result, and nothing else.
void DoTask(const Options& options);

}  // namespace ray

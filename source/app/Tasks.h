#pragma once

#include "source/app/options/Options.h"

namespace ray {

/// Does everything a program does besides rendering, viewing and commands: prints its result, and nothing else.
void DoTask(const Options& options);

}  // namespace ray

#pragma once

#include "source/app/options/Options.h"

namespace ray {

/// Does everything a program does besides rendering, viewing and commands: prints its result, and nothing else.
/// `keys`: as for Listing.
void DoTask(const Options& options, const std::vector<std::string>& keys = {});

}  // namespace ray

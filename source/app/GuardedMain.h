#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// Runs a program so that whatever it throws becomes words on standard error, and the exit status that the help
/// promises.
///   run       gets the words behind the program's name, returns an exit status
///   returns   the exit status
int GuardedMain(Program program, int argc, char** argv, int (*run)(const std::vector<std::string>& words));

}  // namespace ray

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// Puts memory aside with which a program that has run out of it can still end in order. GuardedMain begins with it; a
/// main that does anything before calls it first.
void ReserveMemory();

/// Runs a part of a program so that whatever it throws becomes words on standard error, and the exit status that the
/// help promises, which is returned.
int Guarded(Program program, const std::function<int()>& run);

/// Runs a whole program likewise.
///   run       gets the words behind the program's name, returns an exit status
///   returns   the exit status
int GuardedMain(Program program, int argc, char** argv, int (*run)(const std::vector<std::string>& words));

}  // namespace ray

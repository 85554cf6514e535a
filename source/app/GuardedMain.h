#pragma once

#include <functional>
#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// Reserves memory with which a program that runs out of memory can still exit in order. GuardedMain begins with this;
/// a main that does anything earlier calls it first.
void ReserveMemory();

/// Runs a part of a program, converts its exceptions to a message on standard error, and returns the exit status
/// documented in the help.
int Guarded(const Program& program, const std::function<int()>& run);

/// Runs a whole program and converts its exceptions to a message and an exit status.
///   run       gets the words after the program's name, returns an exit status
///   returns   the exit status
int GuardedMain(const Program& program, int argc, char** argv, int (*run)(const std::vector<std::string>& words));

}  // namespace ray

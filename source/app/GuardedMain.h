#pragma once

#include <functional>
#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// Sets memory aside with which a program that has run out of it can still end in order. GuardedMain begins with this;
/// a main that does anything earlier calls it first.
void ReserveMemory();

/// Runs a part of a program and turns what it throws into a message on standard error and into the exit status that the
/// help promises, which is returned.
int Guarded(const Program& program, const std::function<int()>& run);

/// Runs a whole program and turns what it throws into a message and an exit status.
///   run       gets the words behind the program's name, returns an exit status
///   returns   the exit status
int GuardedMain(const Program& program, int argc, char** argv, int (*run)(const std::vector<std::string>& words));

}  // namespace ray

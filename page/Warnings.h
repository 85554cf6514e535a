#pragma once

#include <string>

namespace ray {

/// Lines that a program would write to standard error, since they were last taken.
std::string& Warnings();

}  // namespace ray

#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// What -list can list.
std::vector<std::string> ListSubjects(Program program);

/// The names of one subject with what they are, or of all of them when `subject` is empty.
std::string Listing(Program program, const std::string& subject);

}  // namespace ray

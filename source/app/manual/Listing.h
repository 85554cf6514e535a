#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// What -list can list.
std::vector<std::string> ListSubjects(const Program& program);

/// The names of one subject with what they are, or of all of them when `subject` is empty. `keys`: what the keys of the
/// viewer do, in lines; none for programs without a window.
std::string Listing(const Program& program, const std::string& subject, const std::vector<std::string>& keys = {});

}  // namespace ray

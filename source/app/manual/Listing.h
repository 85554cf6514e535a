#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// Returns the subjects of -list.
std::vector<std::string> ListSubjects(const Program& program);

/// Returns the names of one subject with descriptions, or of all subjects if `subject` is empty. `keys`: descriptions
/// of the viewer's keys, in lines; empty for programs without a window.
std::string Listing(const Program& program, const std::string& subject, const std::vector<std::string>& keys = {});

}  // namespace ray

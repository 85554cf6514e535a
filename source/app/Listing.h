#pragma once

#include <string>
#include <vector>

namespace ray {

/// What -list can list.
std::vector<std::string> ListSubjects();

/// The names of one subject with what they are, or of all of them when `subject` is empty.
std::string Listing(const std::string& subject);

}  // namespace ray

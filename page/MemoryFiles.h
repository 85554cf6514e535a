#pragma once

#include <map>
#include <string>

namespace ray {

/// The files of a page, by their absolute names: what a scene can name, and nothing else is there. The current folder
/// is "/".
std::map<std::string, std::string>& MemoryFiles();

}  // namespace ray

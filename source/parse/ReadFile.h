#pragma once

#include <string>

#include "source/parse/Files.h"

namespace ray {

/// The contents of a regular file that Files found. Throws FileError, also if a link or another kind of file has taken
/// its place since. Only this function and StandardInput read input; the page in a browser has its own version.
std::string ReadFile(const FoundFile& file);

}  // namespace ray

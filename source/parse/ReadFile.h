#pragma once

#include <string>

#include "source/parse/Files.h"

namespace ray {

/// The whole of a regular file that Files found. Throws FileError, also when a link or another kind of file has taken
/// its place since then. Together with StandardInput this is all that reads input; the page in a browser has its own.
std::string ReadFile(const FoundFile& file);

}  // namespace ray

#pragma once

#include <span>
#include <string>

namespace R2 {

/// What a file looks like by its first bytes, for messages about files that are not what was expected: "a web page
/// (HTML)", "a PNG image", "text". Empty when it looks like nothing that is known here. Knows formats that this program
/// does not read, and never takes more than a guess for it: whether a file can be read is for its reader to say.
std::string LooksLike(std::span<const unsigned char> bytes);

}  // namespace R2

#pragma once

#include <string>

namespace ray {

/// A text in UTF-8 in the letters that the overlay has: letters without their accents, plain dashes and quotes, and one
/// "?" for any other sign, also for a byte that is no UTF-8.
std::string InAscii(const std::string& text);

}  // namespace ray

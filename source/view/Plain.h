#pragma once

#include <string>

namespace ray {

/// A number with at most `digits` digits that count, but all those before the point, and never as a power of ten.
std::string Plain(double number, int digits);

}  // namespace ray

#pragma once

#include <cstddef>

namespace R1 {

/// How many samples are taken together at most, so that loops over them become vector instructions. In mode path half
/// as many take 1 to 7 % more time, twice as many 2 to 5 % less on one thread but 7 % more on two.
inline constexpr std::size_t batch_size = 128;

}  // namespace R1

#pragma once

namespace R3 {

/// How solids are combined: what is in any of them, in all of them, or in the first and in none of the others.
enum class CsgOperation { unite, intersect, subtract };

}  // namespace R3

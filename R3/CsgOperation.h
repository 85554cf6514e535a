#pragma once

namespace R3 {

/// The operations on solids: points in any of them, in all of them, or in the first and in none of the others.
enum class CsgOperation { unite, intersect, subtract };

}  // namespace R3

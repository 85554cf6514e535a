#pragma once

#include <span>

namespace R2 {

/// Returns true if an ICC profile names itself sRGB, in its description or elsewhere, as all sRGB profiles do. Colors
/// are interpreted as sRGB; no other profile is applied.
bool IsNamedSrgb(std::span<const unsigned char> profile);

inline constexpr const char* other_profile =
    " has a color profile other than sRGB's, which is not applied: its colors are interpreted as sRGB";

}  // namespace R2

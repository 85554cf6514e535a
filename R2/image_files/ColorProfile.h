#pragma once

#include <span>

namespace R2 {

/// Whether an ICC profile calls itself sRGB, in its description or elsewhere, as all profiles of sRGB do. Colors are
/// taken as sRGB's; no other profile is applied.
bool IsNamedSrgb(std::span<const unsigned char> profile);

inline constexpr const char* other_profile =
    " has a color profile other than sRGB's, which is not applied: its colors are taken as sRGB's";

}  // namespace R2

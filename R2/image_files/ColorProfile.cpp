#include "R2/image_files/ColorProfile.h"

#include <algorithm>
#include <string_view>

namespace R2 {

bool IsNamedSrgb(std::span<const unsigned char> profile) {
  using namespace std::string_view_literals;
  // The description is ASCII in version 2 of profiles, and UTF-16 in version 4.
  const auto holds = [&](std::string_view name) {
    return std::search(profile.begin(), profile.end(), name.begin(), name.end()) != profile.end();
  };
  return holds("sRGB"sv) || holds("s\0R\0G\0B"sv);
}

}  // namespace R2

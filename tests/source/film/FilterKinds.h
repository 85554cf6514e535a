#pragma once

#include <array>

#include "source/film/Filter.h"

namespace ray {

inline constexpr std::array kinds{FilterKind::box, FilterKind::gaussian, FilterKind::mitchell, FilterKind::lanczos};

inline const char* NameOf(FilterKind kind) { return filter_names[static_cast<std::size_t>(kind)]; }

}  // namespace ray

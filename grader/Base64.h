#pragma once

#include <span>
#include <string>

namespace ray::grade {

/// Returns bytes as base64 text for a page: RFC 4648, section 4.
std::string Base64(std::span<const unsigned char> bytes);

}  // namespace ray::grade

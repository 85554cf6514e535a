#pragma once

#include <span>
#include <string>

namespace ray::grade {

/// Bytes as letters that a page may hold: RFC 4648, section 4.
std::string Base64(std::span<const unsigned char> bytes);

}  // namespace ray::grade

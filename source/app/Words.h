#pragma once

#include <cstdint>
#include <span>
#include <string>

/// Words that users type and read.
namespace ray {

/// The words as one would type them into a shell, quoted where needed.
std::string ShellLine(std::span<const std::string> words);

/// "width" for "--width"; empty when there are dashes only.
std::string WithoutDashes(const std::string& word);

/// With so many digits behind the point, whatever the locale.
std::string Fixed(double number, int digits_behind_point);

/// "1 pixel", "2 pixels"
std::string Counted(std::uint64_t count, const std::string& noun);

}  // namespace ray

#pragma once

#include <span>
#include <string_view>

namespace ray::comp30019 {

class Line;
class Reader;

/// A word that begins a line.
struct Command {
  std::string_view name;
  std::string_view usage;
  void (*read)(Reader&, Line&);
};

/// Null when there is none of that name; letter case counts.
const Command* FindCommand(std::string_view name);
std::span<const std::string_view> CommandNames();

}  // namespace ray::comp30019

#pragma once

#include <array>
#include <string>

namespace ray {

enum class Program { raypro, rayview, rayimg, raygrade };
inline constexpr std::array programs{Program::raypro, Program::rayview, Program::rayimg, Program::raygrade};

inline std::string NameOf(Program program) {
  constexpr std::array names{"raypro", "rayview", "rayimg", "raygrade"};
  return names[static_cast<std::size_t>(program)];
}

}  // namespace ray

#pragma once

#include <array>
#include <string>

namespace ray {

/// The programs whose options are in the one table.
enum class Program { raypro, rayview };
inline constexpr std::array programs{Program::raypro, Program::rayview};

inline std::string NameOf(Program program) { return program == Program::raypro ? "raypro" : "rayview"; }
inline Program TheOther(Program program) { return program == Program::raypro ? Program::rayview : Program::raypro; }

}  // namespace ray

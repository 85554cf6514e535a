#pragma once

#include <array>

#include "source/app/options/Program.h"

namespace ray {

/// The programs that take a scene and share most options.
inline constexpr std::array scene_programs{Program::raypro, Program::rayview};
inline Program TheOther(Program program) { return program == Program::raypro ? Program::rayview : Program::raypro; }

}  // namespace ray

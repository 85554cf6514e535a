#pragma once

#include <array>
#include <functional>

#include "source/app/options/Program.h"

namespace ray {

/// The programs that take a scene and share most options.
inline const std::array scene_programs{std::cref(Program::raypro), std::cref(Program::rayview)};
inline const std::array programs{std::cref(Program::raypro), std::cref(Program::rayview), std::cref(Program::rayimg),
                                 std::cref(Program::raygrade)};
inline const Program& TheOther(const Program& program) {
  return program == Program::raypro ? Program::rayview : Program::raypro;
}

}  // namespace ray

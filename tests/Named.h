#pragma once

#include <string>

#include "source/text/EnumNames.h"

namespace project {

/// A word as the command line has it, where a setting wants the enumerator of that name.
struct Named {
  std::string name;
  template <class Enum>
  operator Enum() const {
    return ray::Named<Enum>(name).value();
  }
};

}  // namespace project

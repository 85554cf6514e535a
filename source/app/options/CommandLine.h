#pragma once

#include <memory>
#include <span>
#include <string>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// Reads the words after a program's name. Names and options may be in any order; -width 512, --width 512 and
/// -width=512 are equivalent; of a repeated option the last one counts; after "--" everything is a name. Throws
/// UsageError.
std::unique_ptr<Options> ReadWords(const Program& program, std::span<const std::string> words);

/// ReadWords with the type of the program's own options.
template <class Own = RenderOptions>
Own ReadCommandLine(const Program& program, std::span<const std::string> words) {
  return As<Own>(*ReadWords(program, words));
}

}  // namespace ray

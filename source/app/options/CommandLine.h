#pragma once

#include <memory>
#include <span>
#include <string>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// What the words behind a program's name ask for. Names and options in any order; -width 512, --width 512 and
/// -width=512 are the same; of an option given twice the last counts; behind "--" everything is a name. Throws
/// UsageError.
std::unique_ptr<Options> ReadWords(const Program& program, std::span<const std::string> words);

/// The same, as the program's own options.
template <class Own = RenderOptions>
Own ReadCommandLine(const Program& program, std::span<const std::string> words) {
  return As<Own>(*ReadWords(program, words));
}

}  // namespace ray

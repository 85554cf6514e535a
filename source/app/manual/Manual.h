#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// Returns the manual page raypro.1 or rayview.1, as troff source with man macros.
std::string ManualPage(const Program& program);

/// Returns the names of the pages that -man accepts in addition to the program's own.
std::vector<std::string> ManualPages();
/// Returns one of them, or the program's own if `name` is empty.
std::string ManualPage(const std::string& name, const Program& program);

/// Escapes text for roff: backslashes and dashes, and control characters at the start of a line.
std::string Roff(const std::string& text);

/// Returns paragraphs, each preceded by a bold tag: pairs of tag and text.
template <class List>
std::string Tagged(const List& list) {
  std::string text;
  for (const auto& [tag, meaning] : list) text += ".TP\n.B " + Roff(tag) + "\n" + Roff(meaning) + "\n";
  return text;
}

}  // namespace ray

#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// The manual page raypro.1 or rayview.1, in the language of the man macros.
std::string ManualPage(const Program& program);

/// The pages that -man can be asked for besides the program's own.
std::vector<std::string> ManualPages();
/// One of them, or the program's own when `name` is empty.
std::string ManualPage(const std::string& name, const Program& program);

/// Text as roff takes it literally: a backslash and a dash are escaped, a line never starts with a control character.
std::string Roff(const std::string& text);

/// Paragraphs, each with a bold word or two before it: pairs of both.
template <class List>
std::string Tagged(const List& list) {
  std::string text;
  for (const auto& [tag, meaning] : list) text += ".TP\n.B " + Roff(tag) + "\n" + Roff(meaning) + "\n";
  return text;
}

}  // namespace ray

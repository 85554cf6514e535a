#pragma once

#include <string>
#include <string_view>

namespace ray {

/// Returns a hint about the first character of a word that resembles an ASCII character or is invisible, as in text
/// copied from web pages: "it has U+2212, a minus sign: type '-1'". Empty if there is no such character.
std::string LookAlikeHint(std::string_view word);

/// Returns the word with the ASCII characters that its characters resemble.
std::string WithoutLookAlikes(std::string_view word);

}  // namespace ray

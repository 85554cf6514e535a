#pragma once

#include <string>
#include <string_view>

namespace ray {

/// Returns a hint about the first character of a word that looks like one of ASCII, or is invisible, as in text copied
/// from web pages: "it has U+2212, a minus sign: type '-1'". Returns an empty text if there is none.
std::string LookAlikeHint(std::string_view word);

/// Returns the word with ASCII characters in place of those that look like them.
std::string WithoutLookAlikes(std::string_view word);

}  // namespace ray

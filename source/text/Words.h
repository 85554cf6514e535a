#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "source/text/NumberText.h"

/// Functions for words that users type and read.
namespace ray {

/// Splits a text into words at white space.
std::vector<std::string> SplitWords(const std::string& text);

/// Returns the words as typed into a shell, quoted if necessary.
std::string ShellLine(std::span<const std::string> words);

/// Returns "width" for "--width"; empty if there are only dashes.
std::string WithoutDashes(const std::string& word);

/// Returns "1 pixel" or "2 pixels".
std::string Counted(std::uint64_t count, const std::string& noun);

/// Returns "none, grid or octree".
std::string OneOf(const std::vector<std::string>& choices);

/// Returns "; did you mean 'grid'?" if one of the choices is close to the word, begins it, or begins with it; otherwise
/// an empty text.
std::string DidYouMean(const std::string& word, const std::vector<std::string>& choices);

/// Returns true for a dash and a letter, an option. A dash and a digit or a point is a negative number, a single dash a
/// name.
bool LooksLikeOption(const std::string& word);

/// An option as it was typed: "--width=512" has the name "width" and the attached value "512".
struct TypedOption {
  std::string name;
  std::optional<std::string> attached;
};
TypedOption SplitOption(const std::string& word);

}  // namespace ray

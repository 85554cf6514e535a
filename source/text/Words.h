#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "source/text/NumberText.h"

/// Words that users type and read.
namespace ray {

/// The words of a text, separated by any white space.
std::vector<std::string> SplitWords(const std::string& text);

/// The words as one would type them into a shell, quoted where needed.
std::string ShellLine(std::span<const std::string> words);

/// "width" for "--width"; empty when there are dashes only.
std::string WithoutDashes(const std::string& word);

/// "1 pixel", "2 pixels"
std::string Counted(std::uint64_t count, const std::string& noun);

/// "none, grid or octree"
std::string OneOf(const std::vector<std::string>& choices);

/// "; did you mean 'grid'?" when one of the choices is close to the word, or begins it, or begins with it; otherwise
/// nothing.
std::string DidYouMean(const std::string& word, const std::vector<std::string>& choices);

/// A dash and a letter: an option. A dash and a digit or a point is a negative number, a dash alone a name.
bool LooksLikeOption(const std::string& word);

/// An option as it was typed: "--width=512" is named "width" and brings "512" along.
struct TypedOption {
  std::string name;
  std::optional<std::string> attached;
};
TypedOption SplitOption(const std::string& word);

}  // namespace ray

#include "source/text/Words.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

#include "source/text/Suggestion.h"

namespace ray {
namespace {

bool IsPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string("-_./=+,:@%").find(c) != std::string::npos;
}

std::string ShellWord(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, IsPlain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// Returns the longest choice that begins the word or begins with it: "path" for "pathtracer". Shorter words are too
/// ambiguous.
std::string LongestInCommon(const std::string& word, const std::vector<std::string>& choices) {
  constexpr std::size_t fewest_letters = 4;
  std::string found;
  for (const std::string& choice : choices) {
    const bool has_common = word.starts_with(choice) || choice.starts_with(word);
    if (has_common && std::min(word.size(), choice.size()) >= fewest_letters && choice.size() > found.size())
      found = choice;
  }
  return found;
}

}  // namespace

std::vector<std::string> SplitWords(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string ShellLine(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + ShellWord(word);
  return line;
}

std::string WithoutDashes(const std::string& word) {
  const auto first = word.find_first_not_of('-');
  return first == std::string::npos ? "" : word.substr(first);
}

std::string Counted(std::uint64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string OneOf(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) text += i + 1 < choices.size() ? ", " : " or ";
    text += choices[i];
  }
  return text;
}

std::string DidYouMean(const std::string& word, const std::vector<std::string>& choices) {
  const std::vector<std::string_view> views(choices.begin(), choices.end());
  const std::string hint = Suggestion(word, views, "");
  if (hint.starts_with("did")) return "; " + hint;
  const std::string similar = LongestInCommon(word, choices);
  return similar.empty() ? "" : "; did you mean '" + similar + "'?";
}

bool LooksLikeOption(const std::string& word) {
  if (word.size() < 2 || word[0] != '-') return false;
  return !(word[1] == '.' || (word[1] >= '0' && word[1] <= '9'));
}

TypedOption SplitOption(const std::string& word) {
  const std::string text = word.substr(word.starts_with("--") ? 2 : 1);
  const auto equals = text.find('=');
  if (equals == std::string::npos) return {text, {}};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace ray

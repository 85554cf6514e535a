#include "source/parse/SceneError.h"

#include <algorithm>
#include <utility>

#include "source/parse/Text.h"

namespace ray {
namespace {

constexpr std::size_t max_shown = 20;

std::string RightAligned(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

/// Returns white space as wide as the line up to the caret; tabs remain tabs.
std::string Indent(const std::string& line, std::size_t characters) {
  std::string indent;
  std::size_t wide = 0;
  for (std::size_t i = 0; i < line.size() && wide < characters; ++i) {
    if (CountCharacters(std::string_view(line).substr(i, 1)) == 0) continue;  // a continuation byte
    indent += line[i] == '\t' ? '\t' : ' ';
    ++wide;
  }
  return indent + std::string(characters - wide, ' ');
}

std::string Join(const std::vector<SceneError>& all) {
  std::string report;
  for (std::size_t i = 0; i < std::min(all.size(), max_shown); ++i) {
    if (i > 0) report += '\n';
    report += all[i].Format();
  }
  if (all.size() > max_shown) {
    const std::size_t more = all.size() - max_shown;
    const std::string at_least = all.size() >= SceneErrors::max_kept ? "at least " : "";
    report += "\nand " + at_least + std::to_string(more) + (more == 1 ? " more error" : " more errors");
  }
  return report;
}

constexpr std::size_t max_warnings = 100;

}  // namespace

std::string SceneError::Format() const {
  std::string text = Place(file, line, column) + ": error: " + message;
  if (line > 0 && !source_line.empty()) {
    const std::string shown = ShownLine(source_line);
    const std::string number = RightAligned(std::to_string(line), 5);
    const std::size_t before = column - 1, characters = CountCharacters(shown);
    const std::size_t underlined = std::clamp<std::size_t>(length, 1, std::max(characters, before + 1) - before);
    text += "\n" + number + " | " + shown;
    text +=
        "\n" + std::string(number.size(), ' ') + " | " + Indent(shown, before) + "^" + std::string(underlined - 1, '~');
    if (!hint.empty()) text += " " + hint;
  } else if (!hint.empty()) {
    text += "; " + hint;
  }
  for (const std::string& place : included_from) text += "\nincluded from " + Escaped(place);
  return text;
}

SceneErrors::SceneErrors(std::vector<SceneError> all) : std::runtime_error(Join(all)), all_(std::move(all)) {}

void Report::Error(SceneError error) {
  errors_.push_back(std::move(error));
  if (errors_.size() >= SceneErrors::max_kept) ThrowErrors();
}

void Report::Warn(const std::string& place, const std::string& message) {
  std::string line = place + ": warning: " + message;
  // A file that is read twice, for two uses, produces the same warnings twice.
  if (std::ranges::find(warnings_, line) != warnings_.end()) return;
  if (warnings_.size() < max_warnings)
    warnings_.push_back(std::move(line));
  else
    ++warnings_omitted_;
}

void Report::ThrowErrors() {
  if (!errors_.empty()) throw SceneErrors(std::exchange(errors_, {}));
}

std::vector<std::string> Report::Warnings() const {
  std::vector<std::string> all = warnings_;
  if (warnings_omitted_ > 0) all.push_back("and " + std::to_string(warnings_omitted_) + " more warnings");
  return all;
}

}  // namespace ray

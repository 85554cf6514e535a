#include "R2/image_files/TextSettings.h"

#include <algorithm>

namespace R2 {
namespace {

/// Returns true if the key is a keyword: 1 to 79 printable characters, with single spaces inside only.
bool IsKeyword(const std::string& key) {
  if (key.empty() || key.size() > 79 || key.front() == ' ' || key.back() == ' ') return false;
  const auto is_printable = [](char c) { return c >= ' ' && c <= '~'; };
  return std::all_of(key.begin(), key.end(), is_printable) && key.find("  ") == std::string::npos;
}

/// Removes zero bytes, which would end the text.
std::string WithoutZeros(std::string text) {
  std::replace(text.begin(), text.end(), '\0', ' ');
  return text;
}

}  // namespace

std::string Utf8OfLatin1(std::string_view text) {
  std::string utf8;
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += {static_cast<char>(0xc0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3f))};
    }
  }
  return utf8;
}

ImageSettings WritableAsPng(const ImageSettings& settings) {
  ImageSettings writable;
  for (const auto& [key, value] : settings) {
    std::string& text = writable[IsKeyword(key) ? key : "Comment"];
    text += WithoutZeros(IsKeyword(key) ? value : key + ": " + value + "\n");
  }
  return writable;
}

namespace {

/// Escapes line breaks; a colon is escaped in keys only, so that the first unescaped one ends the key.
std::string Escaped(const std::string& text, bool is_key) {
  std::string escaped;
  for (char c : text) {
    if (c == '\n') {
      escaped += "\\n";
    } else if (c == '\r') {
      escaped += "\\r";
    } else if (c == '\\' || (is_key && c == ':')) {
      escaped += {'\\', c};
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string Unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    const char next = is_escape ? text[i + 1] : '\0';
    if (next == 'n' || next == 'r') {
      plain += next == 'n' ? '\n' : '\r';
      ++i;
    } else if (next == '\\' || next == ':') {
      plain += next;
      ++i;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

/// Adds a line. A line without a key, from another program, is stored under "comment".
void AddLine(ImageSettings& settings, std::string_view line) {
  std::size_t colon = 0;
  while (colon < line.size() && line[colon] != ':') colon += line[colon] == '\\' ? 2 : 1;
  if (colon + 1 < line.size() && line[colon + 1] == ' ') {
    settings.insert_or_assign(Unescaped(line.substr(0, colon)), Unescaped(line.substr(colon + 2)));
    return;
  }
  std::string& comment = settings["comment"];
  comment += (comment.empty() ? "" : "\n") + std::string(line);
}

}  // namespace

std::string CommentText(const ImageSettings& settings) {
  std::string text;
  for (const auto& [key, value] : settings) text += Escaped(key, true) + ": " + Escaped(value, false) + "\n";
  return text;
}

ImageSettings SettingsOfComment(std::string_view text) {
  ImageSettings settings;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.empty()) AddLine(settings, line);
  }
  return settings;
}

}  // namespace R2

#include "source/text/Quoting.h"

#include <algorithm>

namespace ray {
namespace {

bool Continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The first character of a text: its length in bytes, and whether it is safe on a terminal.
struct Character {
  std::size_t bytes = 1;
  bool is_safe = false;
};

// Returns true for characters that could move the cursor, ring, or change the direction of writing: C0, DEL, C1, and
// the bidirectional controls.
bool IsControl(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x200E || c == 0x200F || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069);
}

// The Unicode Standard, table 3-7: shortest forms only, no surrogates, nothing above U+10FFFF.
bool IsScalarValue(char32_t c, std::size_t bytes) {
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  return c >= least[bytes] && c <= 0x10FFFF && !(c >= 0xD800 && c <= 0xDFFF);
}

Character First(std::string_view s) {
  const auto [bytes, code] = FirstCharacter(s);
  return {bytes, !IsControl(code)};
}

std::string Hexadecimal(char c) {
  constexpr char digits[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
}

}  // namespace

CodedCharacter FirstCharacter(std::string_view s) {
  const auto lead = static_cast<unsigned char>(s[0]);
  if (lead < 0x80) return {1, lead};
  const std::size_t bytes = lead >= 0xF8 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
  if (bytes == 1 || s.size() < bytes) return {};
  char32_t c = lead & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!Continues(s[i])) return {};
    c = c << 6 | (static_cast<unsigned char>(s[i]) & 0x3Fu);
  }
  if (!IsScalarValue(c, bytes)) return {};
  return {bytes, c};
}

std::size_t CountCharacters(std::string_view bytes) {
  return static_cast<std::size_t>(std::count_if(bytes.begin(), bytes.end(), [](char c) { return !Continues(c); }));
}

std::string Escaped(std::string_view bytes) {
  std::string escaped;
  while (!bytes.empty()) {
    const Character c = First(bytes);
    if (c.is_safe)
      escaped += bytes.substr(0, c.bytes);
    else
      for (const char byte : bytes.substr(0, c.bytes)) escaped += Hexadecimal(byte);
    bytes.remove_prefix(c.bytes);
  }
  return escaped;
}

std::string Quoted(std::string_view bytes) {
  if (bytes.size() <= most_quoted) return "'" + Escaped(bytes) + "'";
  std::size_t kept = most_quoted;
  while (kept > most_quoted - 4 && Continues(bytes[kept])) --kept;  // not inside a character
  return "'" + Escaped(bytes.substr(0, kept)) + "...' (" + std::to_string(bytes.size()) + " bytes)";
}

std::string QuotedPath(std::string_view bytes) { return "'" + Escaped(bytes) + "'"; }

std::string ShownLine(std::string_view line) {
  std::string shown;
  while (!line.empty()) {
    const Character c = First(line);
    if (c.is_safe || line[0] == '\t')
      shown += line.substr(0, c.bytes);
    else if (!Continues(line[0]))
      shown += '?';
    line.remove_prefix(c.bytes);
  }
  return shown;
}

std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string Place(const std::string& file, std::size_t line, std::size_t column) {
  std::string place = Escaped(file);
  if (line > 0) place += ":" + std::to_string(line) + ":" + std::to_string(column);
  return place;
}

}  // namespace ray

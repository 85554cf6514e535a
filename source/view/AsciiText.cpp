#include "source/view/AsciiText.h"

#include <cstdint>
#include <string_view>

namespace ray {
namespace {

/// Letters from U+00C0 on, without their accents.
constexpr std::string_view latin{
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUu"
    "UuWwYyYZzZzZzs"};
constexpr std::uint32_t first_latin = 0xC0;

char InAscii(std::uint32_t sign) {
  if (sign < 0x80) return static_cast<char>(sign);
  if (sign >= first_latin && sign < first_latin + latin.size()) return latin[sign - first_latin];
  if (sign >= 0x2010 && sign <= 0x2015) return '-';
  if (sign >= 0x2018 && sign <= 0x201B) return '\'';
  if (sign >= 0x201C && sign <= 0x201F) return '"';
  return sign == 0xA0 ? ' ' : '?';
}

/// How many bytes follow the first one of a sign; nothing of UTF-8 where that is 0 and the byte is no ASCII.
int BytesBehind(unsigned char first) { return first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0; }

}  // namespace

std::string InAscii(const std::string& text) {
  std::string ascii;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i++]);
    int behind = BytesBehind(first);
    std::uint32_t sign = first;
    if (behind > 0) sign = first & (0x3FU >> behind);
    if (behind == 0 && first >= 0x80) sign = 0xFFFD;
    for (; behind > 0 && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U; --behind)
      sign = sign << 6U | (static_cast<unsigned char>(text[i++]) & 0x3FU);
    ascii += InAscii(behind > 0 ? 0xFFFDU : sign);
  }
  return ascii;
}

}  // namespace ray

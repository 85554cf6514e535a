#include "R2/image_files/PngText.h"

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

}  // namespace R2

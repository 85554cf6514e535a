#include "source/parse/document/TextPlaces.h"

#include <algorithm>

namespace ray {

TextPlaces::TextPlaces(const Text& text) : text_(text) {
  Place place;
  for (std::size_t i = 0; i < text.bytes.size(); ++i) {
    if (i % stride == 0) noted_.push_back(place);
    Step(place, i);
  }
  if (text.bytes.size() % stride == 0) noted_.push_back(place);
}

// A line ends with LF, CR LF or CR. A byte order mark takes no column, and neither do bytes that continue a character.
void TextPlaces::Step(Place& place, std::size_t offset) const {
  const std::string& bytes = text_.bytes;
  const char c = bytes[offset];
  const bool is_cr_of_crlf = c == '\r' && offset + 1 < bytes.size() && bytes[offset + 1] == '\n';
  if (EndsLine(c) && !is_cr_of_crlf) {
    ++place.line;
    place.column = 1;
  } else if (!is_cr_of_crlf && !(offset == 0 && bytes.starts_with("\xEF\xBB\xBF"))) {
    place.column += CountCharacters({&bytes[offset], 1});
  }
}

Token TextPlaces::At(const Extent& extent) const {
  const std::size_t offset = std::min(extent.offset, text_.bytes.size());
  Place place = noted_[offset / stride];
  for (std::size_t i = offset - offset % stride; i < offset; ++i) Step(place, i);
  return {std::string_view(text_.bytes).substr(offset, extent.length), place.line, place.column, false};
}

}  // namespace ray

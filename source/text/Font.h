#pragma once

#include <cstdint>
#include <vector>

namespace ray {

/// The built-in font, in cells of 8 x 16 pixels: the printable ASCII characters, then a box for all others.
inline constexpr int glyph_width = 8, glyph_height = 16, glyph_count = '~' - ' ' + 2;
inline constexpr int box_glyph = glyph_count - 1;

/// Returns the glyph of a byte of text, in [0, glyph_count); -1 for continuation bytes of UTF-8, which have no glyph.
int GlyphOf(char byte);

/// Returns all cells side by side: 255 where there is ink, 0 elsewhere; rows from the bottom.
std::vector<std::uint8_t> GlyphSheet();

}  // namespace ray

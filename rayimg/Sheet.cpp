#include "rayimg/Sheet.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>

#include "rayimg/Images.h"
#include "source/text/Font.h"

namespace ray::rayimg {
namespace {

constexpr int caption_height = glyph_height + 4;
constexpr R2::Color paper{1, 1, 1};

R2::Image Paper(int width, int height) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.Set(x, y, paper);
  return image;
}

void Paste(const R2::Image& image, R2::Image& onto, int left, int bottom) {
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) onto.Set(left + x, bottom + y, image.At(x, y));
}

std::vector<int> GlyphsOf(const std::string& text) {
  std::vector<int> glyphs;
  for (const char byte : text)
    if (const int glyph = GlyphOf(byte); glyph >= 0) glyphs.push_back(glyph);
  return glyphs;
}

/// Shortens a caption that does not fit; two dots replace its middle.
std::vector<int> Shortened(std::vector<int> glyphs, std::size_t room) {
  if (glyphs.size() <= room) return glyphs;
  if (room < 5) return {glyphs.begin(), glyphs.begin() + static_cast<std::ptrdiff_t>(room)};
  const std::size_t head = (room - 1) / 2, tail = room - 2 - head;
  std::vector<int> shorter(glyphs.begin(), glyphs.begin() + static_cast<std::ptrdiff_t>(head));
  shorter.insert(shorter.end(), 2, GlyphOf('.'));
  shorter.insert(shorter.end(), glyphs.end() - static_cast<std::ptrdiff_t>(tail), glyphs.end());
  return shorter;
}

/// Writes black letters centered in `width` pixels.
void WriteCaption(R2::Image& onto, const std::string& text, int left, int bottom, int width) {
  static const std::vector<std::uint8_t> sheet = GlyphSheet();
  const std::vector<int> glyphs = Shortened(GlyphsOf(text), static_cast<std::size_t>(width / glyph_width));
  int x0 = left + (width - static_cast<int>(glyphs.size()) * glyph_width) / 2;
  for (const int glyph : glyphs) {
    for (int y = 0; y < glyph_height; ++y)
      for (int x = 0; x < glyph_width; ++x)
        if (sheet[static_cast<std::size_t>((y * glyph_count + glyph) * glyph_width + x)])
          onto.Set(x0 + x, bottom + y, {});
    x0 += glyph_width;
  }
}

using Row = std::span<const Tile>;

std::vector<Row> RowsOf(const std::vector<Tile>& tiles, std::size_t columns) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < tiles.size(); i += columns)
    rows.push_back(Row(tiles).subspan(i, std::min(columns, tiles.size() - i)));
  return rows;
}

std::int64_t WidthOf(Row row, const SheetLayout& layout) {
  std::int64_t width = static_cast<std::int64_t>(row.size() - 1) * layout.gap;
  for (const Tile& tile : row) width += tile.image.Width();
  return width;
}

}  // namespace

R2::Image Padded(const R2::Image& image, int width, int height) {
  R2::Image padded = Paper(width, height);
  Paste(image, padded, (width - image.Width()) / 2, (height - image.Height()) / 2);
  return padded;
}

R2::Image Arranged(const std::vector<Tile>& tiles, const SheetLayout& layout) {
  const std::vector<Row> rows = RowsOf(tiles, layout.columns);
  const int below = layout.has_captions ? caption_height : 0;
  std::int64_t width = 0, height = static_cast<std::int64_t>(rows.size() - 1) * layout.gap;
  for (const Row& row : rows) {
    width = std::max(width, WidthOf(row, layout));
    height += row[0].image.Height() + below;
  }
  width += 2 * layout.margin, height += 2 * layout.margin;
  RefuseTooManyPixels(width, height);
  R2::Image sheet = Paper(static_cast<int>(width), static_cast<int>(height));
  int top = sheet.Height() - layout.margin;
  for (const Row& row : rows) {
    const int bottom = top - row[0].image.Height();
    int left = layout.margin;
    for (const Tile& tile : row) {
      assert(tile.image.Height() == row[0].image.Height());
      Paste(tile.image, sheet, left, bottom);
      if (layout.has_captions) WriteCaption(sheet, tile.caption, left, bottom - below + 2, tile.image.Width());
      left += tile.image.Width() + layout.gap;
    }
    top = bottom - below - layout.gap;
  }
  return sheet;
}

}  // namespace ray::rayimg

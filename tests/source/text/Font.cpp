#include "source/text/Font.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

std::vector<std::uint8_t> CellOf(int glyph) {
  const auto sheet = ray::GlyphSheet();
  std::vector<std::uint8_t> cell;
  for (int y = 0; y < ray::glyph_height; ++y)
    for (int x = 0; x < ray::glyph_width; ++x)
      cell.push_back(sheet[static_cast<std::size_t>((y * ray::glyph_count + glyph) * ray::glyph_width + x)]);
  return cell;
}

TEST(Font, EveryGlyphDiffersFromEveryOther) {
  std::set<std::vector<std::uint8_t>> seen;
  for (int glyph = 0; glyph < ray::glyph_count; ++glyph) EXPECT_TRUE(seen.insert(CellOf(glyph)).second) << glyph;
}

// Letters that touch are hard to distinguish.
TEST(Font, GlyphsLeaveTheirLastColumnFree) {
  for (int glyph = 0; glyph < ray::glyph_count; ++glyph)
    for (int y = 0; y < ray::glyph_height; ++y)
      EXPECT_EQ(CellOf(glyph)[static_cast<std::size_t>(y * ray::glyph_width + ray::glyph_width - 1)], 0) << glyph;
}

TEST(Font, OnlyTheSpaceIsEmpty) {
  for (int glyph = 0; glyph < ray::glyph_count; ++glyph)
    EXPECT_EQ(CellOf(glyph) == std::vector<std::uint8_t>(ray::glyph_width * ray::glyph_height), glyph == 0) << glyph;
}

TEST(Font, EveryNonAsciiCharacterIsOneBox) {
  EXPECT_EQ(ray::GlyphOf(' '), 0);
  EXPECT_EQ(ray::GlyphOf('~'), '~' - ' ');
  EXPECT_EQ(ray::GlyphOf('\n'), ray::box_glyph);
  int boxes = 0;
  for (char byte : std::string("\xc3\xa9\xe2\x82\xac"))  // é €
    boxes += ray::GlyphOf(byte) == ray::box_glyph;
  EXPECT_EQ(boxes, 2);
}

}  // namespace

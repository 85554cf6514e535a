#include "source/film/FillGaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "source/film/BlockOrder.h"

namespace ray {
namespace {

constexpr int columns = 61, rows = 53;

TEST(BlockOrder, EveryPixelOfABlockHasItsPlace) {
  const PixelRectangle block{16, 8, 24, 16};
  std::set<int> places;
  for (int row = block.y0; row < block.y1; ++row)
    for (int column = block.x0; column < block.x1; ++column) {
      const int place = BlockOrder::PlaceOf(column, row);
      places.insert(place);
      const auto [c, r] = BlockOrder::PixelAt(place, block);
      EXPECT_EQ(c, column);
      EXPECT_EQ(r, row);
    }
  EXPECT_EQ(places.size(), 64u);
  EXPECT_EQ(*places.rbegin(), 63);
}

TEST(BlockOrder, PlacesInPartOfABlockMatchTheWhole) {
  const auto [column, row] = BlockOrder::PixelAt(9, {19, 13, 24, 16});
  EXPECT_EQ(BlockOrder::PlaceOf(column, row), 9);
  EXPECT_EQ(column / 8, 2);
  EXPECT_EQ(row / 8, 1);
}

// The distance of a pixel from the nearest of the first `places`, in a plane of such blocks: at most half a diagonal of
// a square lattice, half a side of the quincunx, which is rotated.
TEST(BlockOrder, EveryPrefixOfAPowerOfTwoIsALattice) {
  for (int places = 1; places <= 64; places *= 2) {
    std::set<int> distances;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        int nearest = 1000;
        for (int dy = -8; dy < 16; ++dy)
          for (int dx = -8; dx < 16; ++dx)
            if (BlockOrder::PlaceOf(x + dx + 8, y + dy + 8) < places && (dx != 0 || dy != 0))
              nearest = std::min(nearest, dx * dx + dy * dy);
        if (BlockOrder::PlaceOf(x, y) < places) distances.insert(nearest);
      }
    EXPECT_EQ(distances, (std::set<int>{64 / places})) << places << " have the same distance, squared";
  }
}

R2::Image Ramp() {
  R2::Image image(columns, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) image.Set(x, y, {x / 64.0, y / 64.0, (x + y) / 128.0});
  return image;
}

struct Partly {
  R2::Image image{columns, rows};
  std::vector<char> is_known = std::vector<char>(static_cast<std::size_t>(columns * rows));

  void Know(int x, int y, const R2::Color& color) {
    image.Set(x, y, color);
    is_known[static_cast<std::size_t>(y * columns + x)] = 1;
  }
};

/// A ramp with the first `places` of each block known and the image's corner at x0, y0.
Partly KnowingPlaces(int places, int x0, int y0) {
  Partly partly;
  const R2::Image ramp = Ramp();
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      if (BlockOrder::PlaceOf(x0 + x, y0 + y) < places) partly.Know(x, y, ramp.At(x, y));
  return partly;
}

TEST(FillGaps, RestoresALinearImageAwayFromItsEdges) {
  const R2::Image ramp = Ramp();
  for (int places = 1; places <= 64; places *= 2)
    for (const int corner : {0, 3, 13}) {
      Partly partly = KnowingPlaces(places, corner, corner);
      FillGaps(partly.image, corner, corner, partly.is_known);
      // The edge, which lacks a neighbor, has an effect up to a distance of a block plus half, a quarter ... of one.
      for (int y = 16; y < rows - 16; ++y)
        for (int x = 16; x < columns - 16; ++x) {
          EXPECT_NEAR(partly.image.At(x, y).r, ramp.At(x, y).r, 1e-6) << places << ", " << corner << ", " << x;
          EXPECT_NEAR(partly.image.At(x, y).g, ramp.At(x, y).g, 1e-6);
        }
    }
}

TEST(FillGaps, KeepsKnownPixelsAndInterpolatesTheRest) {
  for (int places = 1; places < 64; places += 3) {
    Partly partly = KnowingPlaces(places, 5, 2);
    const R2::Image before = partly.image;
    FillGaps(partly.image, 5, 2, partly.is_known);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const R2::Color color = partly.image.At(x, y);
        if (partly.is_known[static_cast<std::size_t>(y * columns + x)]) {
          EXPECT_EQ(color, before.At(x, y));
        }
        EXPECT_GE(color.r, 0);
        EXPECT_LE(color.r, (columns - 1) / 64.0);
      }
  }
}

TEST(FillGaps, ASingleKnownPixelFillsTheImage) {
  Partly partly;
  const R2::Color red{1, 0, 0};
  partly.Know(31, 4, red);
  FillGaps(partly.image, 0, 0, partly.is_known);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) EXPECT_EQ(partly.image.At(x, y), red);
}

TEST(FillGaps, WithoutKnownPixelsTheImageIsUnchanged) {
  Partly partly;
  partly.image.Set(3, 3, {1, 1, 1});
  const R2::Image before = partly.image;
  FillGaps(partly.image, 0, 0, partly.is_known);
  EXPECT_EQ(partly.image, before);
}

// Plain means would turn it into steps of gray.
TEST(FillGaps, ADiagonalEdgeStaysSharp) {
  for (const bool rises : {false, true}) {
    const auto is_white = [&](int x, int y) { return rises ? x > y : x + y > 48; };
    Partly partly;
    for (int y = 0; y < rows; y += 2)
      for (int x = 0; x < columns; x += 2) partly.Know(x, y, is_white(x, y) ? R2::Color{1, 1, 1} : R2::Color{});
    FillGaps(partly.image, 0, 0, partly.is_known);
    for (int i = 9; i < 40; i += 2) {
      const int x = i, y = rises ? i : 48 - i;
      EXPECT_EQ(partly.image.At(x, y), R2::Color()) << "on the edge, " << x << " " << y;
      EXPECT_EQ(partly.image.At(x + 2, y), (R2::Color{1, 1, 1})) << x << " " << y;
      EXPECT_EQ(partly.image.At(x - 2, y), R2::Color()) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace ray

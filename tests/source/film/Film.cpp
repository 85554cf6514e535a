#include "source/film/Film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/sample/Random.h"
#include "tests/Named.h"
#include "tests/Project.h"
#include "tests/source/film/FilterKinds.h"

namespace ray {
namespace {

/// Adds `samples` per pixel, from number `first` on, at random places; `color` returns the color for the key of each.
template <typename Shade>
void Expose(Film& film, int part, std::uint32_t first, std::uint32_t last, const Shade& color) {
  for (int i = 0; i < film.Blocks(); ++i) {
    Film::Block& block = film[i];
    if (block.sums[part].IsEmpty()) block.sums[part] = film.EmptySums(i);
    const PixelRectangle pixels = film.PixelsOf(i);
    for (int y = pixels.y0; y < pixels.y1; ++y)
      for (int x = pixels.x0; x < pixels.x1; ++x)
        for (std::uint32_t k = first; k < last; ++k) {
          const RandomKey key =
              RandomKey(7).Child(static_cast<std::uint64_t>(x)).Child(static_cast<std::uint64_t>(y)).Child(k);
          const double at_x = x + key.Child(1).Number(), at_y = y + key.Child(2).Number();
          block.sums[part].Add(x, y, at_x, at_y, color(at_x, at_y, key), film.filter());
        }
    block.samples[part] += last - first;
  }
}

R2::Color Noise(double, double, const RandomKey& key) {
  return {key.Child(3).Number(), key.Child(4).Number(), key.Child(5).Number()};
}

TEST(Film, AConstantImageStaysConstantUnderEveryFilter) {
  for (const FilterKind kind : kinds) {
    Film film(21, 19, {0, 0, 21, 19}, kind);
    Expose(film, 0, 0, 4, [](double, double, const RandomKey&) { return R2::Color{0.25, 3, 0.75}; });
    const R2::Image image = film.Image();
    for (int y = 0; y < 19; ++y)
      for (int x = 0; x < 21; ++x) {
        EXPECT_NEAR(image.At(x, y).r, 0.25, 1e-7) << NameOf(kind);
        EXPECT_NEAR(image.At(x, y).g, 3, 1e-6) << NameOf(kind);
        EXPECT_NEAR(image.At(x, y).b, 0.75, 1e-7) << NameOf(kind);
      }
  }
}

TEST(Film, ACutHasThePixelsOfTheWhole) {
  for (const FilterKind kind : kinds) {
    Film film(60, 50, {3, 2, 57, 50}, kind);
    Expose(film, 0, 0, 2, Noise);
    Expose(film, 1, 2, 3, Noise);
    const R2::Image whole = film.Part(1);
    for (const PixelRectangle& part : {PixelRectangle{3, 2, 57, 50}, {20, 13, 37, 41}, {3, 40, 9, 50}}) {
      const Film cut = film.Cut(part);
      EXPECT_TRUE(cut.HasBothParts());
      const R2::Image image = cut.Part(1);
      ASSERT_EQ(image.Width(), part.Width());
      for (int y = 0; y < image.Height(); ++y)
        for (int x = 0; x < image.Width(); ++x)
          ASSERT_TRUE(image.At(x, y) == whole.At(part.x0 - 3 + x, part.y0 - 2 + y)) << NameOf(kind) << x << ' ' << y;
    }
  }
}

/// The image by definition: each pixel adds up the weights of all samples of the whole.
TEST(Film, PixelsAreWeightedMeansOfSamplesInReach) {
  constexpr int width = 20, height = 18;
  constexpr std::uint32_t samples = 3;
  for (const FilterKind kind : kinds) {
    Film film(width, height, {0, 0, width, height}, kind);
    Expose(film, 0, 0, samples, Noise);
    const R2::Image image = film.Image();
    for (int py = 0; py < height; ++py)
      for (int px = 0; px < width; ++px) {
        double sum = 0, weights = 0;
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x)
            for (std::uint32_t k = 0; k < samples; ++k) {
              const RandomKey key =
                  RandomKey(7).Child(static_cast<std::uint64_t>(x)).Child(static_cast<std::uint64_t>(y)).Child(k);
              const double w = FilterFormula(kind, x + key.Child(1).Number() - px - 0.5) *
                               FilterFormula(kind, y + key.Child(2).Number() - py - 0.5);
              sum += w * Noise(0, 0, key).r;
              weights += w;
            }
        ASSERT_NEAR(image.At(px, py).r, sum / weights, 2e-5) << NameOf(kind) << ' ' << px << ' ' << py;
      }
  }
}

TEST(Film, SplittingSamplesIntoPassesChangesNoBit) {
  for (const FilterKind kind : kinds) {
    Film once(30, 20, {0, 0, 30, 20}, kind), often = once;
    Expose(once, 0, 0, 7, Noise);
    Expose(often, 0, 0, 2, Noise);
    Expose(often, 0, 2, 3, Noise);
    Expose(often, 0, 3, 7, Noise);
    EXPECT_TRUE(once.Image() == often.Image()) << NameOf(kind);
  }
}

// A pixel is the sum of blocks. The position of their borders may change the last digits of a double, but the floats of
// the image only by rounding. The neighbors in the film change nothing at all.
TEST(Film, AWindowMatchesTheWholeUnderEveryFilter) {
  for (const FilterKind kind : kinds) {
    Film whole(40, 33, {0, 0, 40, 33}, kind);
    Expose(whole, 0, 0, 3, Noise);
    const R2::Image all = whole.Image();
    for (const PixelRectangle& window :
         {PixelRectangle{0, 0, 1, 1}, PixelRectangle{7, 7, 9, 9}, PixelRectangle{16, 8, 24, 16},
          PixelRectangle{39, 32, 40, 33}, PixelRectangle{3, 0, 38, 31}}) {
      Film part(40, 33, window, kind);
      Expose(part, 0, 0, 3, Noise);
      const R2::Image image = part.Image();
      for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x)
          EXPECT_EQ(image.At(x - window.x0, y - window.y0), all.At(x, y)) << NameOf(kind) << ' ' << x << ' ' << y;
    }
  }
}

TEST(Film, TheImageCombinesBothParts) {
  for (const FilterKind kind : kinds) {
    Film film(16, 16, {0, 0, 16, 16}, kind);
    EXPECT_FALSE(film.HasBothParts());
    Expose(film, 0, 0, 4, Noise);
    EXPECT_FALSE(film.HasBothParts());
    Expose(film, 1, 4, 8, Noise);
    EXPECT_TRUE(film.HasBothParts());
    Film at_once(16, 16, {0, 0, 16, 16}, kind);
    Expose(at_once, 0, 0, 8, Noise);
    const R2::Image parts = film.Image(), whole = at_once.Image();
    for (std::size_t i = 0; i < whole.Channels().size(); ++i)
      EXPECT_NEAR(parts.Channels()[i], whole.Channels()[i], 1e-6) << NameOf(kind);
  }
}

TEST(Film, EmptyPixelsAreBlackAndAllAreFinite) {
  Film film(16, 8, {0, 0, 16, 8}, FilterKind::lanczos);
  EXPECT_EQ(film.Image(), R2::Image(16, 8));
  film[0].sums[0] = film.EmptySums(0);
  film[0].sums[0].Add(2, 2, 2.5, 2.5, {HUGE_VAL, std::nan(""), 1e300}, film.filter());
  film[0].samples[0] = 1;
  const R2::Image image = film.Image();
  for (const float channel : image.Channels()) EXPECT_TRUE(std::isfinite(channel));
}

TEST(Film, ThreadsAndTilesChangeNoBitUnderWideFilters) {
  const project::Stage stage(project::Root() / "scenes" / "area_light.scn");
  for (const char* filter : filter_names) {
    RenderSettings settings = project::Sized(45, 37);
    settings.samples = 2;
    settings.filter = project::Named{filter};
    settings.trace.shadow_samples = 1;
    settings.threads = 1;
    const auto expected = project::Render(stage, settings);
    for (const int threads : {2, 7})
      for (const int tile : {1, 8, 24, 64, 0}) {
        settings.threads = threads;
        settings.tile_size = tile;
        EXPECT_TRUE(project::Render(stage, settings).image == expected.image)
            << filter << ", " << threads << " threads, tiles of " << tile;
      }
  }
}

}  // namespace
}  // namespace ray

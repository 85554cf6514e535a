#pragma once

#include <array>
#include <cstdint>

#include "source/film/Film.h"

namespace ray {

/// A sample and its place in the pixel.
struct FilmSample {
  R2::Color color;
  double x = 0.5, y = 0.5;
};

/// Returns a square film whose two parts have these samples per pixel: sample(part, x, y, index), each a FilmSample.
template <typename Sample>
Film TwoPartFilm(int side, const std::array<std::uint32_t, 2>& counts, FilterKind filter, const Sample& sample) {
  Film film(side, side, {0, 0, side, side}, filter);
  for (int i = 0; i < film.Blocks(); ++i)
    for (int part = 0; part < Film::parts; ++part) {
      film[i].sums[part] = film.EmptySums(i);
      film[i].samples[part] = counts[static_cast<std::size_t>(part)];
      const PixelRectangle pixels = film.PixelsOf(i);
      for (int y = pixels.y0; y < pixels.y1; ++y)
        for (int x = pixels.x0; x < pixels.x1; ++x)
          for (std::uint32_t k = 0; k < film[i].samples[part]; ++k) {
            const FilmSample s = sample(part, x, y, k);
            film[i].sums[part].Add(x, y, x + s.x, y + s.y, s.color, film.filter());
          }
    }
  return film;
}

}  // namespace ray

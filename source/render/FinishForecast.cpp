#include "source/render/FinishForecast.h"

#include <algorithm>

#include "source/film/SpreadRectangles.h"
#include "source/render/SecondsOf.h"

namespace ray {
namespace {

// Squares of so many pixels a side are looked at: few, and little of the picture.
constexpr int side_of_part = 128, most_parts = 8;
constexpr double most_looked_at = 1.0 / 32;
// What pictures of 4 to 67 million pixels took beside their parts, as PNG and as JPEG: for a machine that is not always
// as quick, and for memory that the system must find and caches do not hold, by pixel.
constexpr double price_of_whole = 1.2, seconds_of_memory = 8e-9;

}  // namespace

void FinishForecast::Look(const Film& film, R2::Quantization quantization) {
  if (!encode_) return;
  const auto pixels = static_cast<double>(film.Region().Area());
  const int parts =
      std::clamp(static_cast<int>(most_looked_at * pixels / (side_of_part * side_of_part)), 1, most_parts);
  double pixels_seen = 0, seconds = 0;
  for (int i = 0; i < parts; ++i) {
    const Film part = film.Cut(SpreadRectangle(film.Region(), side_of_part, side_of_part, i));
    seconds += LeastSecondsOf(2, [&] { encode_(part.Picture(quantization)); });
    pixels_seen += static_cast<double>(part.Region().Area());
  }
  const double foretold = (price_of_whole * seconds / pixels_seen + seconds_of_memory) * pixels;
  seconds_ = has_looked_ ? (seconds_ + foretold) / 2 : foretold;  // what a look tells of the machine varies
  has_looked_ = true;
}

}  // namespace ray

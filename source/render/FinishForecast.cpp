#include "source/render/FinishForecast.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "source/film/SpreadRectangles.h"

namespace ray {
namespace {

constexpr int side = 128, most_parts = 8;  // of what is looked at, and of that no more than this share of the picture
constexpr double most_looked_at = 1.0 / 32;
// What pictures of 4 to 67 million pixels took beside their parts, as PNG and as JPEG: for a machine that is not always
// as quick, and for memory that the system must find and caches do not hold, by pixel.
constexpr double price_of_whole = 1.2, seconds_of_memory = 8e-9;

/// Of two attempts: one may have to wait for a processor.
template <typename Work>
double LeastSecondsOf(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 2; ++attempt) {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

}  // namespace

void FinishForecast::Look(const Film& film, R2::Quantization quantization) {
  if (!encode_) return;
  const auto pixels = static_cast<double>(film.Region().Area());
  const int parts = std::clamp(static_cast<int>(most_looked_at * pixels / (side * side)), 1, most_parts);
  double looked_at = 0, seconds = 0;
  for (int i = 0; i < parts; ++i) {
    const Film part = film.Cut(SpreadRectangle(film.Region(), side, side, i));
    seconds += LeastSecondsOf([&] { encode_(part.Picture(quantization)); });
    looked_at += static_cast<double>(part.Region().Area());
  }
  const double foretold = (price_of_whole * seconds / looked_at + seconds_of_memory) * pixels;
  seconds_ = has_looked_ ? (seconds_ + foretold) / 2 : foretold;  // what a look tells of the machine varies
  has_looked_ = true;
}

}  // namespace ray

#include "source/sample/PoissonDisk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ray {
namespace {

constexpr std::uint32_t pattern_size = 64;
using Places = std::array<R2::Point, pattern_size>;

/// Returns the squared distance between two points, across an edge if that is shorter.
double SquaredDistance(const R2::Point& a, const R2::Point& b) {
  const double x = std::abs(a.x - b.x), y = std::abs(a.y - b.y);
  const double dx = std::min(x, 1 - x), dy = std::min(y, 1 - y);
  return dx * dx + dy * dy;
}

double SquaredDistanceToFirst(const Places& places, std::uint32_t first, const R2::Point& p) {
  double nearest = 2;
  for (std::uint32_t i = 0; i < first; ++i) nearest = std::min(nearest, SquaredDistance(places[i], p));
  return nearest;
}

Places BestCandidates() {
  Places places;
  constexpr std::uint32_t candidates_for_each = 8;  // per existing point: twice as many gain 2% in distance
  const RandomKey key(1991);
  for (std::uint32_t i = 0; i < pattern_size; ++i) {
    double farthest = -1;
    for (std::uint32_t c = 0; c < candidates_for_each * (i + 1); ++c) {
      const RandomKey own = key.Child(i).Child(c);
      const R2::Point p{own.Child(0).Number(), own.Child(1).Number()};
      const double distance = SquaredDistanceToFirst(places, i, p);
      if (distance > farthest) farthest = distance, places[i] = p;
    }
  }
  return places;
}

}  // namespace

R2::Point PoissonDiskPlace(std::uint32_t index, const RandomKey& key) {
  static const Places places = BestCandidates();
  const RandomKey way = key.Child(index / pattern_size);
  const R2::Point& p = places[index % pattern_size];
  const auto moved = [](double x, double by) { return x + by < 1 ? x + by : x + by - 1; };
  return {moved(p.x, way.Child(0).Number()), moved(p.y, way.Child(1).Number())};
}

}  // namespace ray

#include "source/inspect/ImageLines.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ray {
namespace {

constexpr int most_pieces = 32;          // of a circle as wide as the image, 32nds of the width bend by 1/4096 of it
constexpr double pixels_of_a_piece = 8;  // hidden as a whole

/// Returns the share of the way at which a piece begins, so that pieces of a perspective image are of equal length:
/// depths are inverse linear in the image.
double ShareAt(double piece, double from_depth, double to_depth) {
  return piece * from_depth / ((1 - piece) * to_depth + piece * from_depth);
}

}  // namespace

std::vector<ImageLine> ImageLines::Of(const R3::Point& begin, const R3::Point& end) const {
  R3::Point from = begin, to = end;
  double a = 1, b = 1;  // depths
  if (camera_.IsPinhole()) {
    a = Dot(from - camera_.eye, camera_.towards), b = Dot(to - camera_.eye, camera_.towards);
    const double nearest = std::max(a, b) / 1024;  // nearer points are at the edge of the image, or outside
    if (!(nearest > 0)) return {};
    if (a < nearest) from = from + (nearest - a) / (b - a) * (to - from), a = nearest;
    if (b < nearest) to = to + (nearest - b) / (a - b) * (from - to), b = nearest;
  }
  const auto place_of = [&](const R3::Point& p) { return camera_.PlaceOf(p, width_, height_); };
  std::optional<R2::Point> last = place_of(from);
  const std::optional<R2::Point> goal = place_of(to);
  int pieces = most_pieces;
  if (last && goal && !IsTorn(*last, *goal, from + ShareAt(0.5, a, b) * (to - from))) {
    const R2::Vector way = *goal - *last;
    pieces = static_cast<int>(std::clamp(std::sqrt(Dot(way, way)) / pixels_of_a_piece, 1.0, double{most_pieces}));
  }
  const auto at = [&](int piece) { return from + ShareAt(double(piece) / pieces, a, b) * (to - from); };
  std::vector<ImageLine> lines;
  for (int piece = 0; piece < pieces; ++piece) {
    const std::optional<R2::Point> next = place_of(at(piece + 1));
    const R3::Point middle = at(piece) + 0.5 * (at(piece + 1) - at(piece));
    const std::optional<R2::Point> place = place_of(middle);
    if (last && next && place && !IsTorn(*last, *next, middle)) {
      const auto sight = camera_.RayThrough(place->x, place->y, width_, height_);
      lines.push_back({*last, *next, !sight || !is_visible_(middle, *sight, *place)});
    }
    last = next;
  }
  return lines;
}

/// Returns true for a piece that leaves a panorama at one side and enters it at the other: the middle of its line in
/// the image then looks away from the middle of the piece.
bool ImageLines::IsTorn(const R2::Point& from, const R2::Point& to, const R3::Point& middle) const {
  const auto sight = camera_.RayThrough((from.x + to.x) / 2, (from.y + to.y) / 2, width_, height_);
  return !sight || !(Dot(sight->direction, middle - sight->origin) > 0);
}

}  // namespace ray

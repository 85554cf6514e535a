#include "R3/CsgCrossings.h"

#include <algorithm>
#include <cmath>

namespace R3 {
namespace {

// The maximum number of crossings of a ray with one element. Implicit divides too few stretches to find more.
constexpr int most_crossings = 1 << 14;

/// A crossing that has not been matched with the others yet.
struct Candidate {
  CsgCrossing crossing;
  double steepness = 0;    // |n . d|; only compared between candidates of one line
  bool is_unsure = false;  // may lead in or out: it merges simultaneous crossings of both kinds
};
using Candidates = R1::StackVector<Candidate, 8>;

/// A solid and a line, in the solid's frame.
class LineThroughSolid {
 public:
  LineThroughSolid(const CsgSolid& solid, const Ray& ray)
      : solid_(solid), line_(solid.is_in_place ? ray : solid.part->csg_from_solid.Back(ray)) {
    const double length = Length(line_.direction), middle = MiddleOf(length);
    extent_ = 2 * solid.radius / length;
    // Starts a little more than half the extent before the middle; rounding of t is less than this share of the middle.
    constexpr double share = 0x1p-20;
    line_.t_min = middle - extent_ - share * std::abs(middle), line_.t_max = infinity;
    line_.departure = nullptr, line_.leaving = line_.reaching = -1;
  }

  void Find(const Ray& ray, Candidates& found) {
    if (!(extent_ < infinity)) return;  // zero direction or NaN
    if (solid_.has_one_element) return AddCandidates(ray, found, 0);
    const double reach = MaxComponent(Abs(FromOrigin(line_.origin))) + solid_.reach;
    for (const int element : solid_.elements.AlongLine(line_, 64 * unit_roundoff * reach))
      AddCandidates(ray, found, element);
    std::ranges::sort(found, {}, [](const Candidate& c) { return c.crossing.t; });
  }

 private:
  /// Returns the t nearest to the middle of the box.
  double MiddleOf(double length) const {
    const Vector towards = solid_.center - line_.origin;
    const double square = Dot(line_.direction, line_.direction);
    return IsSafeSquare(square) ? Dot(towards, line_.direction) / square : Dot(towards, Unit(line_.direction)) / length;
  }

  /// Computes the rounding error of moving the ray into the frame, for its origin and for each step along it, including
  /// the error of the frame itself.
  void SetRounding(const Ray& ray) {
    const Matrix& inverse = solid_.part->csg_from_solid.Inverse();
    const Vector shift{std::abs(inverse.m[0][3]), std::abs(inverse.m[1][3]), std::abs(inverse.m[2][3])};
    const double slack = MaxRowSum(inverse) * solid_.part->slack;
    origin_rounding_ =
        Gamma(6) * (AbsTimes(inverse, Abs(FromOrigin(ray.origin))) + shift) + Vector{slack, slack, slack};
    direction_rounding_ = Gamma(6) * AbsTimes(inverse, Abs(ray.direction));
  }

  void AddCandidates(const Ray& ray, Candidates& found, int element) {
    Ray rest = line_;
    for (int count = 0; count < most_crossings;) {
      const Crossings some = solid_.part->solid->CrossingsAlong(rest, element);
      if (some.count == 0) return;
      if (found.empty() && !solid_.is_in_place) SetRounding(ray);
      for (std::size_t i = 0; i < some.count; ++i) found.push_back(CandidateAt(some.hits[i], element));
      if (!some.may_have_more) return;
      rest.t_min = some.hits[some.count - 1].t;
      count += static_cast<int>(some.count);
    }
  }

  Candidate CandidateAt(const Hit& hit, int element) const {
    const Intersection at = solid_.part->solid->PlaceAt(line_, hit, element);
    const Vector n = AsVector(at.normal);
    const double facing = Dot(n, line_.direction), t = std::abs(hit.t);
    const Vector off = at.error + origin_rounding_ + t * direction_rounding_;
    const double size = MaxComponent(Abs(FromOrigin(line_.origin))) + t * MaxComponent(Abs(line_.direction));
    const double half = (Dot(Abs(n), off) + 64 * unit_roundoff * size) / std::abs(facing);
    const double within = half < extent_ ? half : extent_;  // infinite or NaN if the ray lies in the surface
    return {{.t = hit.t,
             .low = hit.t - within,
             .high = hit.t + within,
             .element = element,
             .part = solid_.number,
             .enters = facing < 0},
            std::abs(facing)};
  }

  const CsgSolid& solid_;
  Ray line_;
  double extent_ = 0;  // of the solid along the line, in t; an upper bound
  Vector origin_rounding_, direction_rounding_;
};

/// Merges simultaneous candidates: a line that meets an edge of a mesh exactly hits both of its triangles. If some
/// candidates lead in and others out, as where the line touches a silhouette, the direction of the result is unsure.
Candidate Merged(const Candidate* first, const Candidate* last) {
  Candidate merged =
      *std::max_element(first, last, [](const Candidate& a, const Candidate& b) { return a.steepness < b.steepness; });
  for (const Candidate* other = first; other != last; ++other) {
    merged.is_unsure |= other->crossing.enters != merged.crossing.enters;
    merged.crossing.low = std::min(merged.crossing.low, other->crossing.low);
    merged.crossing.high = std::max(merged.crossing.high, other->crossing.high);
  }
  return merged;
}

void MergeWhereAtOnce(Candidates& found) {
  std::size_t merged = 0;
  for (std::size_t first = 0, last = 0; first < found.size(); first = last) {
    double high = found[first].crossing.high;
    for (last = first + 1; last < found.size() && found[last].crossing.low <= high; ++last)
      high = std::max(high, found[last].crossing.high);
    found[merged++] = Merged(&found[first], &found[first] + (last - first));
  }
  found.truncate(merged);
}

/// Appends crossings that alternate between in and out, starting with in. If two consecutive candidates have the same
/// direction,
///   - an unsure candidate between them is taken as the opposite crossing;
///   - otherwise the steeper one counts: the other is a touch whose direction is due to rounding, or a double root that
///     was found once.
/// A final entry without an exit is dropped.
void AddAlternating(const Candidates& candidates, CsgCrossings& crossings) {
  const std::size_t before = crossings.size();
  const auto is_outside = [&] { return (crossings.size() - before) % 2 == 0; };
  const Candidate* unsure = nullptr;  // the first since the last one kept
  double steepness = 0;               // of the last one kept
  const auto keep = [&](const Candidate& c) {
    CsgCrossing crossing = c.crossing;
    crossing.enters = is_outside();
    crossings.push_back(crossing);
    steepness = c.steepness;
    unsure = nullptr;
  };
  for (const Candidate& next : candidates) {
    if (next.is_unsure) {
      unsure = &next;
    } else if (next.crossing.enters == is_outside()) {
      keep(next);
    } else if (unsure) {
      keep(*unsure);
      keep(next);
    } else if (crossings.size() > before && next.steepness > steepness) {
      crossings.back() = next.crossing;
      steepness = next.steepness;
    }
  }
  if (!is_outside() && unsure) keep(*unsure);
  if (!is_outside()) crossings.truncate(crossings.size() - 1);
}

}  // namespace

void AddCrossings(const CsgSolid& solid, const Ray& ray, CsgCrossings& crossings) {
  Candidates found;
  LineThroughSolid(solid, ray).Find(ray, found);
  if (found.empty()) return;
  MergeWhereAtOnce(found);
  AddAlternating(found, crossings);
}

}  // namespace R3

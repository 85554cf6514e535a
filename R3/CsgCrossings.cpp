#include "R3/CsgCrossings.h"

#include <algorithm>
#include <cmath>

namespace R3 {
namespace {

// The most crossings of a ray with one element. The halvings of Implicit tell no more of a formula's apart, and each costs
// another search.
constexpr int most_crossings = 1 << 14;

/// A crossing before it is known how it fits in with the others.
struct Candidate {
  CsgCrossing crossing;
  double steepness = 0;    // |n . d| over the length of d
  bool is_unsure = false;  // it may lead in or out: several that happen at once, of which some do either
};

/// A solid and a line, in the solid's frame.
class LineThroughSolid {
 public:
  LineThroughSolid(const CsgPart& part, const ElementTree& elements, const Ray& ray)
      : part_(part), elements_(elements), line_(part.csg_from_solid.Back(ray)) {
    const Box& box = elements.Bounds();
    const double length = Length(line_.direction), middle = MiddleOf(box);
    extent_ = 2 * box.Radius() / length;
    // A little more than half the extent before the middle; rounding of t is less than the share of the middle.
    constexpr double share = 0x1p-20;
    line_.t_min = middle - extent_ - share * std::abs(middle), line_.t_max = infinity;
    line_.departure = nullptr, line_.leaving = line_.reaching = -1;
    SetRounding(ray);
  }

  std::vector<Candidate> Candidates() const {
    std::vector<Candidate> found;
    if (!(extent_ < infinity)) return found;  // no direction, or no number
    const double reach = MaxComponent(Abs(FromOrigin(line_.origin))) + MaxReach(elements_.Bounds());
    for (const int element : elements_.AlongLine(line_, 64 * unit_roundoff * reach)) AddCandidates(found, element);
    std::ranges::sort(found, {}, [](const Candidate& c) { return c.crossing.t; });
    return found;
  }

 private:
  static double MaxReach(const Box& box) {
    return std::max(MaxComponent(Abs(FromOrigin(box.low))), MaxComponent(Abs(FromOrigin(box.high))));
  }

  /// The t nearest to the middle of the box.
  double MiddleOf(const Box& box) const {
    const Vector unit = Unit(line_.direction);
    return Dot(box.Center() - line_.origin, unit) / Length(line_.direction);
  }

  /// What moving the ray into the frame rounds, of its origin and of each step along it, and what the frame itself may
  /// be off by.
  void SetRounding(const Ray& ray) {
    if (part_.csg_from_solid.IsIdentity()) return;
    const Matrix& inverse = part_.csg_from_solid.Inverse();
    const Vector shift{std::abs(inverse.m[0][3]), std::abs(inverse.m[1][3]), std::abs(inverse.m[2][3])};
    const double slack = MaxRowSum(inverse) * part_.slack;
    origin_rounding_ =
        Gamma(6) * (AbsTimes(inverse, Abs(FromOrigin(ray.origin))) + shift) + Vector{slack, slack, slack};
    direction_rounding_ = Gamma(6) * AbsTimes(inverse, Abs(ray.direction));
  }

  void AddCandidates(std::vector<Candidate>& found, int element) const {
    Ray rest = line_;
    for (int count = 0; count < most_crossings; ++count) {
      const auto hit = part_.solid->Intersect(rest, element);
      if (!hit) return;
      found.push_back(CandidateAt(*hit, element));
      rest.t_min = hit->t;
    }
  }

  Candidate CandidateAt(const Hit& hit, int element) const {
    const Intersection at = part_.solid->At(line_, hit, element);
    const Vector n = AsVector(at.normal);
    const double facing = Dot(n, line_.direction), t = std::abs(hit.t);
    const Vector off = at.error + origin_rounding_ + t * direction_rounding_;
    const double size = MaxComponent(Abs(FromOrigin(line_.origin))) + t * MaxComponent(Abs(line_.direction));
    const double half = (Dot(Abs(n), off) + 64 * unit_roundoff * size) / std::abs(facing);
    const double within = half < extent_ ? half : extent_;  // infinite or NaN where the ray lies in the surface
    return {{.t = hit.t, .low = hit.t - within, .high = hit.t + within, .enters = facing < 0, .element = element},
            std::abs(facing) / Length(line_.direction)};
  }

  const CsgPart& part_;
  const ElementTree& elements_;
  Ray line_;
  double extent_ = 0;  // of the solid along the line, in t, or more
  Vector origin_rounding_, direction_rounding_;
};

/// Candidates that happen at once as one: an edge between two triangles of a mesh that the line meets exactly is in
/// both of them. Where some lead in and others out, as where the line touches a silhouette, it is not known what they
/// do.
Candidate Merged(const std::vector<Candidate>& at_once) {
  Candidate merged = *std::ranges::max_element(at_once, {}, &Candidate::steepness);
  for (const Candidate& other : at_once) {
    merged.is_unsure |= other.crossing.enters != merged.crossing.enters;
    merged.crossing.low = std::min(merged.crossing.low, other.crossing.low);
    merged.crossing.high = std::max(merged.crossing.high, other.crossing.high);
  }
  return merged;
}

std::vector<Candidate> MergedWhereAtOnce(const std::vector<Candidate>& found) {
  std::vector<Candidate> merged, at_once;
  double high = -infinity;
  for (const Candidate& next : found) {
    if (!at_once.empty() && !(next.crossing.low <= high)) {
      merged.push_back(Merged(at_once));
      at_once.clear(), high = -infinity;
    }
    at_once.push_back(next);
    high = std::max(high, next.crossing.high);
  }
  if (!at_once.empty()) merged.push_back(Merged(at_once));
  return merged;
}

/// Crossings in and out by turns, beginning with in. Where two in a row lead the same way,
///   - one in between of which it is not known what it does did the opposite;
///   - else the steeper of the two counts: the other is a touch, whose sense is that of rounding, or of which the root
///     is double and found once.
/// What is never left again was not entered.
std::vector<CsgCrossing> Alternating(const std::vector<Candidate>& candidates) {
  std::vector<Candidate> kept;
  const Candidate* unsure = nullptr;  // since the last that was kept
  const auto keep = [&](const Candidate& c) {
    const bool enters = kept.size() % 2 == 0;
    kept.push_back(c);
    kept.back().crossing.enters = enters;
    unsure = nullptr;
  };
  for (const Candidate& next : candidates) {
    const bool is_outside = kept.size() % 2 == 0;
    if (next.is_unsure) {
      unsure = &next;
    } else if (next.crossing.enters == is_outside) {
      keep(next);
    } else if (unsure) {
      keep(*unsure);
      keep(next);
    } else if (!kept.empty() && next.steepness > kept.back().steepness) {
      kept.back() = next;
    }
  }
  if (kept.size() % 2 == 1 && unsure) keep(*unsure);
  if (kept.size() % 2 == 1) kept.pop_back();
  std::vector<CsgCrossing> crossings;
  for (const Candidate& c : kept) crossings.push_back(c.crossing);
  return crossings;
}

}  // namespace

std::vector<CsgCrossing> CrossingsOfSolid(const CsgPart& part, const ElementTree& elements, const Ray& ray) {
  const std::vector<Candidate> found = LineThroughSolid(part, elements, ray).Candidates();
  if (found.empty()) return {};
  return Alternating(MergedWhereAtOnce(found));
}

}  // namespace R3

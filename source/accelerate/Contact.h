#pragma once

#include <cmath>
#include <vector>

#include "R3/Departure.h"
#include "source/accelerate/World.h"

/// The rules for hits where surfaces touch: at the start of a ray, at the end of a shadow ray, and where surfaces
/// coincide. Accelerators find crossings; these functions, the same for all accelerators, decide what they mean. All
/// comparisons are along the normal n of the surface, since that is how its error is bounded: a crossing at t lies
/// within
///     off = n . (error of the surface there, per axis), and
///     round = 64 u (|o| + t |d|), which the shape's own test and the rounding of the ray's points add,
/// of the point where the exact ray crosses the exact surface, both rounded up generously. The corresponding distance
/// along the ray depends on the angle and is unbounded.
///
///   Starts.  See R3/Departure.h.
///
///   Ends.  A lamp in the plane of a ceiling is not in its shadow. A surface that contains the end of a shadow ray,
///          within
///   the errors, is not in between. It hides that point only if the point is on a surface too, by the next rule.
///
///   Coincident surfaces.  Hits are coincident with the nearest if they are at the same point within the errors and
///   their tangent planes agree: over the smaller of the two, they part by no more than that. Of coincident surfaces,
///   one that emits is in front of those that do not, then the one with the lowest primitive id, regardless of how the
///   distances are rounded. So a lamp in the plane of a ceiling shines, whichever comes first in the file.
///   All are compared with the nearest alone, so that the order in which hits are found does not matter: a surface that
///   emits and is coincident with the nearest is seen, even if another lies between the two. A path leaves a clear
///   solid before it meets what the solid stands on, as if there were a gap; but between two clear solids there is
///   none, and it enters the one before it leaves the other.
namespace ray {

/// Returns true if a crossing near the start of `ray`, whose t_min is below 0, is ahead of the path; always true if the
/// ray has no departure.
bool IsAhead(const World& world, const R3::Ray& ray, const WorldHit& hit);

/// Returns true if a crossing blocks a shadow ray, which ends at its t_max or at the primitive that it reaches.
bool IsInTheWay(const World& world, const R3::Ray& ray, const WorldHit& hit);
/// The share of t_max before which a crossing blocks a shadow ray with certainty.
inline constexpr double end_of_certainty = 0.9375;
/// The t_max of a ray that reaches a primitive, relative to its t: far enough beyond to find coincident surfaces.
inline constexpr double beyond_target = 1 + 0x1p-20;

/// Returns the visible hit of a ray.
///   hits   the nearest one, and all that may be coincident with it, in any order
WorldHit SeenOf(const World& world, const R3::Ray& ray, std::vector<WorldHit> hits);

/// Returns the nearest hit of a ray and those that are coincident with it, each once, in the order in which they hide
/// each other: those that emit first, then by primitive.
///   hits   as for SeenOf
std::vector<WorldHit> CoincidentOf(const World& world, const R3::Ray& ray, std::vector<WorldHit> hits);

/// Returns the end, in t, of the search for hits coincident with one at t, for rays whose direction is not much shorter
/// than 1. Coincident hits part by at most 2^8 u S along the normal, where S is the ray's largest coordinates as above.
/// This end is 2^33 u t and 2^18 u times the scene's size farther along the ray. That includes all except some hits
/// seen at an angle of less than 2^-10, which are the same for every accelerator.
inline double EndOfCoincidence(const World& world, double t) {
  return t + 0x1p-20 * std::abs(t) + world.CoincidenceWindow();
}

}  // namespace ray

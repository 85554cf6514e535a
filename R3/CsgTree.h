#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "R1/StackVector.h"
#include "R3/Box.h"
#include "R3/CsgPart.h"

namespace R3 {

/// A tree of boxes that finds the solids of a Csg that matter to a ray.
///
/// The box of a part is tight by operation. A point outside of it is outside of the part, whatever is assumed about the
/// solids within: it is outside of all parts of a union, of one part of an intersection, of the first of a difference.
/// So a solid matters only at points in its own box and in the boxes of all parts above it. If the ray has no such
/// point between t_min and t_max, the solid can be skipped without changing a hit in that range. The rest of an
/// intersection can be skipped if one of its parts is never crossed, the rest of a difference if its first is not.
class CsgTree {
 public:
  CsgTree() = default;
  ///   boxes   one per part, tight by operation; empty if the part is
  ///   pad     the padding of boxes, see CsgSolid: base + share * the largest coordinate of a ray's origin
  CsgTree(const std::vector<CsgPart>& parts, std::vector<Box> boxes, double pad_base, double pad_share);

  /// Calls `add` with the index of each solid that may matter to the ray. `add` appends crossings to `found`; crossings
  /// of solids that turn out not to matter are removed again.
  template <typename Crossings, typename Add>
  void ForEachSolid(const Ray& ray, Crossings& found, const Add& add) const {
    const Slabs slabs(ray, pad_base_ + pad_share_ * MaxComponent(Abs(FromOrigin(ray.origin))));
    R1::StackVector<Operation, 16> operations;
    operations.assign(deepest_, {});
    for (std::size_t i = 0; i < steps_.size();) {
      const Step& step = steps_[i];
      if (step.of != none) {
        const Step& whole = steps_[step.of];
        Operation& operation = operations[whole.operation];
        if (found.size() == operation.before_last) {
          found.truncate(operation.before_all);
          i = whole.end;
          continue;
        }
        operation.before_last = found.size();
      }
      if (step.is_tested && !slabs.Meet(step.bounds)) {
        i = step.end;
        continue;
      }
      if (step.operation != none) operations[step.operation] = {found.size(), found.size()};
      if (step.solid != none) add(step.solid);
      ++i;
    }
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// A box, followed by the steps up to `end` that are relevant to rays through the box.
  struct Step {
    std::array<Point, 2> bounds;  // low, high
    std::uint32_t end = 0;
    std::uint32_t solid = none;      // the part that is a solid
    std::uint32_t operation = none;  // the level of an intersection or a difference
    std::uint32_t of = none;         // the enclosing one; it ends if the part before this one is never crossed
    bool is_tested = true;           // false if the box equals that of the enclosing step
  };
  /// The numbers of crossings found before the first and before the latest part of an operation.
  struct Operation {
    std::size_t before_all = 0, before_last = 0;
  };

  /// A ray prepared for tests with padded boxes.
  class Slabs {
   public:
    Slabs(const Ray& ray, double pad) : t_min_(ray.t_min), t_max_(ray.t_max) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        inverse_[i] = 1 / ray.direction[axis];
        is_backward_[i] = std::signbit(inverse_[i]);
        const double ahead = is_backward_[i] ? -pad : pad;
        near_origin_[i] = ray.origin[axis] + ahead, far_origin_[i] = ray.origin[axis] - ahead;
      }
    }

    /// Returns true if the ray meets the box. A product of 0 and infinity is NaN if the ray lies in a plane; the
    /// comparisons then leave the interval as it was.
    bool Meet(const std::array<Point, 2>& bounds) const {
      double enter = t_min_, leave = t_max_;
      const auto clip = [&](std::size_t axis, double Point::*coordinate) {
        const double near = bounds[is_backward_[axis]].*coordinate, far = bounds[!is_backward_[axis]].*coordinate;
        const double from = (near - near_origin_[axis]) * inverse_[axis];
        const double to = (far - far_origin_[axis]) * inverse_[axis];
        enter = from > enter ? from : enter;
        leave = to < leave ? to : leave;
      };
      clip(0, &Point::x), clip(1, &Point::y), clip(2, &Point::z);
      return enter <= leave;
    }

   private:
    std::array<double, 3> near_origin_, far_origin_, inverse_;
    std::array<bool, 3> is_backward_;
    double t_min_, t_max_;
  };

  class Builder;

  std::vector<Step> steps_;
  std::uint32_t deepest_ = 0;  // the maximum nesting depth of intersections and differences
  double pad_base_ = 0, pad_share_ = 0;
};

}  // namespace R3

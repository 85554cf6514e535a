#include "R3/CsgTree.h"

#include <numeric>
#include <utility>

namespace R3 {
namespace {

/// The largest union whose parts get no additional boxes: they would cost more than they save.
constexpr std::size_t few_parts = 4;

}  // namespace

/// Makes the steps. Not recursive, since operations can be nested a hundred thousand deep.
class CsgTree::Builder {
 public:
  Builder(const std::vector<CsgPart>& parts, std::vector<Box> boxes) : parts_(parts), boxes_(std::move(boxes)) {
    CutBoxes();
    ListChildren();
  }

  void Build(CsgTree& tree) {
    if (boxes_[0].IsEmpty()) return;
    tasks_.push_back({.part = 0});
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      if (task.ends != none)
        tree.steps_[task.ends].end = static_cast<std::uint32_t>(tree.steps_.size());
      else
        Emit(tree, task);
    }
  }

 private:
  /// A part, or a range of the parts of a union, that still has to become steps; or the end of a step.
  struct Task {
    std::uint32_t part = none;
    std::size_t first = 0, last = 0;  // indices into children_
    std::uint32_t around = none;      // the step with the enclosing box
    std::uint32_t level = 0;          // number of intersections and differences around it
    std::uint32_t of = none;          // see Step
    std::uint32_t ends = none;
  };

  /// Clips the box of each part by the boxes of all parts above it.
  void CutBoxes() {
    for (std::size_t i = 1; i < parts_.size(); ++i)
      boxes_[i] = Common(boxes_[i], boxes_[static_cast<std::size_t>(parts_[i].parent)]);
  }

  /// Lists the nonempty children of each part contiguously.
  void ListChildren() {
    first_child_.assign(parts_.size() + 1, 0);
    const auto for_each = [&](const auto& use) {
      for (std::size_t i = 1; i < parts_.size(); ++i)
        if (!boxes_[i].IsEmpty()) use(i, static_cast<std::size_t>(parts_[i].parent));
    };
    for_each([&](std::size_t, std::size_t parent) { ++first_child_[parent + 1]; });
    std::partial_sum(first_child_.begin(), first_child_.end(), first_child_.begin());
    children_.resize(first_child_.back());
    std::vector<std::size_t> next = first_child_;
    for_each([&](std::size_t i, std::size_t parent) { children_[next[parent]++] = static_cast<std::uint32_t>(i); });
  }

  void Emit(CsgTree& tree, const Task& task) {
    const auto number = static_cast<std::uint32_t>(tree.steps_.size());
    const Box box = task.part != none ? boxes_[task.part] : HullOf(task);
    Step step{.bounds = {box.low, box.high}, .of = task.of};
    if (task.around != none) {
      const Step& around = tree.steps_[task.around];
      step.is_tested = !(around.bounds[0] == box.low && around.bounds[1] == box.high);
    }
    Task within{.around = number, .level = task.level};
    const bool is_solid = task.part != none && parts_[task.part].solid;
    if (is_solid) {
      step.solid = task.part;
    } else if (task.part != none && parts_[task.part].operation != CsgOperation::unite) {
      step.operation = within.level++;
      tree.deepest_ = std::max(tree.deepest_, within.level);
    }
    tree.steps_.push_back(step);
    tasks_.push_back({.ends = number});
    if (is_solid) return;
    within.first = task.part != none ? first_child_[task.part] : task.first;
    within.last = task.part != none ? first_child_[task.part + 1] : task.last;
    if (step.operation != none)
      AddOperands(within, parts_[task.part].operation);
    else
      AddUnited(within);
  }

  Box HullOf(const Task& group) const {
    Box hull;
    for (std::size_t k = group.first; k < group.last; ++k) hull.Extend(boxes_[children_[k]]);
    return hull;
  }

  /// Adds the parts of an intersection or a difference, with the first on top of the stack.
  void AddOperands(Task next, CsgOperation operation) {
    const auto [first, last] = std::pair(next.first, next.last);
    for (std::size_t k = last; k-- > first;) {
      const bool needs_one_before = operation == CsgOperation::intersect ? k > first : k == first + 1;
      next.part = children_[k], next.of = needs_one_before ? next.around : none;
      tasks_.push_back(next);
    }
  }

  /// Adds the parts of a union. Many parts are split into two halves at the median along the longest side.
  void AddUnited(Task next) {
    const auto [first, last] = std::pair(next.first, next.last);
    if (last - first <= few_parts) {
      for (std::size_t k = last; k-- > first;) {
        next.part = children_[k];
        tasks_.push_back(next);
      }
      return;
    }
    const int axis = MaxAxis(HullOf(next).Size());
    const auto at = [&](std::size_t k) { return children_.begin() + static_cast<std::ptrdiff_t>(k); };
    const auto center = [&](std::uint32_t part) { return boxes_[part].Center()[axis]; };
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(at(first), at(middle), at(last),
                     [&](std::uint32_t a, std::uint32_t b) { return center(a) < center(b); });
    next.first = middle;
    tasks_.push_back(next);
    next.first = first, next.last = middle;
    tasks_.push_back(next);
  }

  const std::vector<CsgPart>& parts_;
  std::vector<Box> boxes_;                // the region in which each part matters
  std::vector<std::size_t> first_child_;  // of each part, an index into children_; with one extra entry at the end
  std::vector<std::uint32_t> children_;
  std::vector<Task> tasks_;
};

CsgTree::CsgTree(const std::vector<CsgPart>& parts, std::vector<Box> boxes, double pad_base, double pad_share)
    : pad_base_(pad_base), pad_share_(pad_share) {
  Builder(parts, std::move(boxes)).Build(*this);
}

}  // namespace R3

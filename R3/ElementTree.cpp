#include "R3/ElementTree.h"

#include <algorithm>
#include <numeric>

namespace R3 {
namespace {

/// The number of elements below which testing their boxes costs more than it saves.
constexpr std::size_t few_elements = 4;

}  // namespace

ElementTree::ElementTree(const Shape& shape) : elements_(static_cast<std::size_t>(shape.Elements())) {
  std::iota(elements_.begin(), elements_.end(), 0);
  nodes_.push_back({{}, 0, elements_.size(), 0});
  Build(shape);
}

// Not recursive, and split by count, so that coincident elements do not increase the depth.
void ElementTree::Build(const Shape& shape) {
  std::vector<Point> centers;
  for (int i = 0; i < shape.Elements(); ++i) centers.push_back(shape.Bounds(i).Center());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t first = nodes_[i].first, last = nodes_[i].last;
    for (std::size_t k = first; k < last; ++k) nodes_[i].box.Extend(shape.Bounds(elements_[k]));
    if (last - first <= few_elements) continue;
    const int axis = MaxAxis(nodes_[i].box.Size());
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t k) { return elements_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(middle), at(last), [&](int a, int b) {
      return centers[static_cast<std::size_t>(a)][axis] < centers[static_cast<std::size_t>(b)][axis];
    });
    nodes_[i].children = nodes_.size();
    nodes_.push_back({{}, first, middle, 0});
    nodes_.push_back({{}, middle, last, 0});
  }
}

std::vector<int> ElementTree::AlongLine(const Ray& ray, double pad) const {
  Ray line = ray;
  line.t_min = -infinity, line.t_max = infinity;
  const BoxRay box_ray(line);
  std::vector<int> found;
  std::vector<std::size_t> waiting{0};
  while (!waiting.empty()) {
    const Node& node = nodes_[waiting.back()];
    waiting.pop_back();
    if (!Entry(node.box, box_ray, pad)) continue;
    if (node.children != 0)
      waiting.insert(waiting.end(), {node.children, node.children + 1});
    else
      for (std::size_t k = node.first; k < node.last; ++k) found.push_back(elements_[k]);
  }
  return found;
}

}  // namespace R3

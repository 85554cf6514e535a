#include "source/integrate/lights/LightTree.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "R3/Numeric.h"
#include "source/sample/Random.h"

namespace ray {
namespace {

constexpr double least_weight = 0x1p-24, least_cosine = 0.1;
// Numbers are kept in this range, so that their sums and quotients are finite and above 0.
constexpr double tiny = 1e-300, huge = 1e300;
constexpr double farthest = 1e150;  // its square is finite

/// A place that is behind only by rounding may be in front. Sides are decided per light, by the sign of a sum of four
/// terms. A decision for a whole box must hold for its lights, so it includes a margin for the rounding of both.
constexpr double side_error = R3::Gamma(20);

double Bounded(double x) { return x > tiny ? std::min(x, huge) : tiny; }

R3::Box BoxOf(const LightBound& light) {
  const R3::Point& c = light.center;
  const double r = light.radius;
  if (r == 0) return {c, c};
  return {{R3::NextDown(c.x - r), R3::NextDown(c.y - r), R3::NextDown(c.z - r)},
          {R3::NextUp(c.x + r), R3::NextUp(c.y + r), R3::NextUp(c.z + r)}};
}

/// Heights of a box above the plane through p with normal N.
struct Heights {
  double least = 0, greatest = 0;
  double magnitude = 0;  // of the terms summed
};

Heights HeightsOf(const R3::Box& box, const R3::Point& p, const R3::Vector& N) {
  Heights heights;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = N[axis] * (box.low[axis] - p[axis]), b = N[axis] * (box.high[axis] - p[axis]);
    heights.least += std::min(a, b);
    heights.greatest += std::max(a, b);
    heights.magnitude += std::max(std::abs(a), std::abs(b));
  }
  return heights;
}

/// Returns the greatest cosine with N of a direction from p into a sphere that does not contain p.
///   cosine   of the direction to its middle
///   sine     of the angle under which its radius is seen, in [0, 1]
///   source   Estevez, Kulla (2018), section 3, theta_i minus theta_u, without angles
double GreatestCosine(double cosine, double sine) {
  if (sine == 0) return cosine;
  const double sphere_cosine = std::sqrt((1 - sine) * (1 + sine));
  if (cosine >= sphere_cosine) return 1;
  return cosine * sphere_cosine + std::sqrt(std::max(0.0, 1 - cosine * cosine)) * sine;
}

/// Returns the divisor at a distance for attenuation by ca + la d + qa d^2; above 0.
template <typename FallingOff>
double DivisorAt(double d, const FallingOff& f) {
  const double divisor = f.ca + f.la * d + f.qa * d * d;
  return divisor > 0 ? divisor : 1;
}

/// Returns the light with its power divided by ca if it is not attenuated, so that its law is 1.
LightBound InUnitsOfItsLaw(LightBound light) {
  if (light.la > 0 || light.qa > 0) return light;
  if (light.ca > 0) light.power = Bounded(light.power / light.ca);
  light.ca = 1;
  return light;
}

/// Groups lights by their attenuation law, those without attenuation first; the last of `most` groups may contain
/// several laws.
std::vector<std::vector<int>> ByLaw(const std::vector<LightBound>& lights, const std::vector<int>& among,
                                    std::size_t most) {
  std::vector<std::array<double, 3>> laws{{1, 0, 0}};
  std::vector<std::vector<int>> groups(most);
  for (const int i : among) {
    const LightBound& light = lights[static_cast<std::size_t>(i)];
    const std::array law{light.ca, light.la, light.qa};
    const auto known = std::find(laws.begin(), laws.end(), law);
    const auto group = static_cast<std::size_t>(known - laws.begin());
    if (known == laws.end() && laws.size() < most) laws.push_back(law);
    groups[std::min(group, most - 1)].push_back(i);
  }
  std::erase_if(groups, [](const std::vector<int>& group) { return group.empty(); });
  return groups;
}

struct Range {
  std::vector<int>::iterator begin, end;
};

/// Splits a range in two halves at the median along the longest side of the box of the centers; lights at one place by
/// their number.
std::array<Range, 2> Halves(const Range& range, const std::vector<LightBound>& lights) {
  const auto center = [&](int light) { return lights[static_cast<std::size_t>(light)].center; };
  R3::Box box;
  for (auto i = range.begin; i != range.end; ++i) box.Extend(center(*i));
  const int axis = MaxAxis(box.Size());
  const auto middle = range.begin + (range.end - range.begin) / 2;
  std::nth_element(range.begin, middle, range.end, [&](int a, int b) {
    const double at_a = center(a)[axis], at_b = center(b)[axis];
    return at_a < at_b || (at_a == at_b && a < b);
  });
  return {Range{range.begin, middle}, Range{middle, range.end}};
}

std::vector<Range> Sixteenths(const Range& range, const std::vector<LightBound>& lights) {
  std::vector<Range> parts{range};
  for (int round = 0; round < 4; ++round) {
    std::vector<Range> halves;
    for (const Range& part : parts) {
      if (part.end - part.begin == 1) {
        halves.push_back(part);
      } else {
        for (const Range& half : Halves(part, lights)) halves.push_back(half);
      }
    }
    parts = std::move(halves);
  }
  return parts;
}

}  // namespace

LightTree::LightTree(std::vector<LightBound> lights) : slots_(lights.size()) {
  std::vector<int> finite;
  std::vector<double> powers;
  for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
    LightBound& light = lights[static_cast<std::size_t>(i)];
    assert(light.power >= 0);
    if (light.power == 0) continue;
    if (light.is_infinite) {
      slots_[static_cast<std::size_t>(i)].infinite = static_cast<int>(infinite_.size());
      infinite_.push_back(i);
      powers.push_back(Bounded(light.power));
      infinite_power_ = Bounded(infinite_power_ + powers.back());
    } else {
      assert(IsFinite(FromOrigin(light.center)) && std::isfinite(light.radius) && light.radius >= 0);
      light = InUnitsOfItsLaw(light);
      finite.push_back(i);
    }
  }
  if (!powers.empty()) {
    const double largest = *std::max_element(powers.begin(), powers.end());
    for (double& power : powers) power = std::max(power, least_weight * largest);
    among_infinite_.emplace(powers);
  }
  for (std::vector<int>& group : ByLaw(lights, finite, most_children - 1)) AddTree(lights, std::move(group));
  has_lone_tree_ = infinite_.empty() && roots_.size() == 1 && nodes_.size() > 1;
}

void LightTree::AddTree(const std::vector<LightBound>& lights, std::vector<int> finite) {
  std::vector<Range> ranges{{finite.begin(), finite.end()}};  // of the nodes
  const std::size_t root = nodes_.size();
  roots_.push_back(static_cast<int>(root));
  nodes_.emplace_back();
  for (std::size_t i = root; i < nodes_.size(); ++i) {
    const Range range = ranges[i - root];
    if (range.end - range.begin == 1) {
      const LightBound& light = lights[static_cast<std::size_t>(*range.begin)];
      Node& leaf = nodes_[i];
      leaf.box = BoxOf(light);
      leaf.center = light.center;
      leaf.radius = light.radius;
      leaf.power = Bounded(light.power);
      leaf.ca = light.ca, leaf.la = light.la, leaf.qa = light.qa;
      leaf.light = *range.begin;
      slots_[static_cast<std::size_t>(leaf.light)].node = static_cast<int>(i);
      continue;
    }
    nodes_[i].first_child = static_cast<int>(nodes_.size());
    for (const Range& part : Sixteenths(range, lights)) {
      ++nodes_[i].children;
      nodes_.emplace_back().parent = static_cast<int>(i);
      ranges.push_back(part);
    }
  }
  Summarize(root);
}

void LightTree::Summarize(std::size_t root) {
  for (std::size_t i = nodes_.size(); i-- > root;) {  // children before their parents
    Node& node = nodes_[i];
    if (node.children == 0) continue;
    for (const Node& child : ChildrenOf(node)) node.box.Extend(child.box);
    // Halved first, since sums of coordinates may overflow.
    const R3::Vector low = 0.5 * FromOrigin(node.box.low), high = 0.5 * FromOrigin(node.box.high);
    node.center = R3::Point{} + (low + high);
    node.radius = Length(high - low);
  }
  // Lights at one place have no distance at which to compare them; then any works.
  const double radius = nodes_[root].radius, reference = radius > 0 ? std::min(radius, farthest) : 1;
  for (std::size_t i = nodes_.size(); i-- > root;)
    if (nodes_[i].children > 0) SummarizePowers(nodes_[i], reference);
}

/// Sets powers as if all lights were attenuated by the first child's law up to the reference, and the mean of the laws
/// by power. For lights of one law these are the sum of powers and that law.
void LightTree::SummarizePowers(Node& node, double reference) {
  const auto children = ChildrenOf(node);
  const double first = Bounded(DivisorAt(reference, children.front()));
  const auto relative = [&](const Node& child) { return Bounded(Bounded(DivisorAt(reference, child)) / first); };
  const auto power = [&](const Node& child) { return Bounded(child.power / relative(child)); };
  for (const Node& child : children) node.power = Bounded(node.power + power(child));
  for (const Node& child : children) {
    const double share = power(child) / node.power, divisor = relative(child);
    node.ca += share * (child.ca / divisor);
    node.la += share * (child.la / divisor);
    node.qa += share * (child.qa / divisor);
  }
}

// Uses few divisions and roots, since sixteen of these are computed per shadow ray.
double LightTree::Importance(const Node& node, const R3::Vector& to_center, double height) {
  const double distance = Length(to_center), farther = std::max(distance, node.radius);
  const double d = farther < farthest ? farther : farthest;
  double cosine = 1;
  if (distance > node.radius) {
    const double inverse = 1 / distance;
    cosine = GreatestCosine(height * inverse, node.radius * inverse);
  }
  const double unshaded = node.power * (cosine > least_cosine ? cosine : least_cosine);
  return Bounded(unshaded / DivisorAt(d, node));
}

bool LightTree::IsLit(const Node& node, const R3::Point& p, const R3::Vector& N, double height) const {
  if (node.children == 0) return !(height + node.radius <= 0);
  const Heights heights = HeightsOf(node.box, p, N);
  const double error = side_error * heights.magnitude;
  if (heights.greatest + error <= 0) return false;
  if (heights.least > error) return true;
  return std::ranges::any_of(ChildrenOf(node),
                             [&](const Node& child) { return IsLit(child, p, N, Dot(child.center - p, N)); });
}

double LightTree::ImportanceIfLit(const Node& node, const R3::Point& p, const R3::Vector& N) const {
  const R3::Vector to_center = node.center - p;
  const double height = Dot(to_center, N);
  return IsLit(node, p, N, height) ? Importance(node, to_center, height) : 0;
}

LightTree::Weights LightTree::FromImportance(const std::array<double, most_children>& importance, std::size_t count) {
  const auto end = importance.begin() + static_cast<std::ptrdiff_t>(count);
  const double inverse = 1 / *std::max_element(importance.begin(), end);
  Weights weights;
  weights.count = count;
  for (std::size_t i = 0; i < weights.count; ++i) {
    weights.of[i] = importance[i] > 0 ? std::max(importance[i] * inverse, least_weight) : 0;
    weights.sum += weights.of[i];
  }
  return weights;
}

LightTree::Weights LightTree::OfTreesAndInfinite(const R3::Point& p, const R3::Vector& N) const {
  std::array<double, most_children> importance;
  for (std::size_t i = 0; i < roots_.size(); ++i)
    importance[i] = ImportanceIfLit(nodes_[static_cast<std::size_t>(roots_[i])], p, N);
  importance[roots_.size()] = infinite_power_;
  return FromImportance(importance, roots_.size() + 1);
}

LightTree::Weights LightTree::OfChildren(const Node& node, const R3::Point& p, const R3::Vector& N) const {
  std::array<double, most_children> importance;
  const auto children = ChildrenOf(node);
  for (std::size_t i = 0; i < children.size(); ++i) importance[i] = ImportanceIfLit(children[i], p, N);
  return FromImportance(importance, children.size());
}

std::optional<LightTree::Choice> LightTree::Choose(const R3::Point& p, const R3::Vector& N, double u) const {
  double probability = 1;
  // Chooses one of the weights by u, which is then mapped to a uniform number again.
  const auto choose = [&](const Weights& weights) {
    const double target = std::min(u, below_one) * weights.sum;
    std::size_t chosen = 0;
    double before = 0, after = 0;
    for (std::size_t i = 0; i < weights.count; ++i) {
      if (weights.of[i] == 0) continue;
      chosen = i;
      before = after;
      after += weights.of[i];
      if (target < after) break;
    }
    probability *= weights.of[chosen] / weights.sum;
    u = std::clamp((target - before) / weights.of[chosen], 0.0, below_one);
    return chosen;
  };

  std::size_t tree = 0;
  if (!has_lone_tree_) {
    const Weights top = OfTreesAndInfinite(p, N);
    if (!(top.sum > 0)) return {};
    tree = choose(top);
    if (tree == roots_.size()) {
      const DiscreteDistribution::Drawn drawn = among_infinite_->Draw(u);
      return Choice{infinite_[drawn.index], probability * drawn.probability};
    }
  }
  const Node* node = &nodes_[static_cast<std::size_t>(roots_[tree])];
  while (node->children > 0) {
    const Weights weights = OfChildren(*node, p, N);
    if (!(weights.sum > 0)) return {};
    node = &nodes_[static_cast<std::size_t>(node->first_child) + choose(weights)];
  }
  return Choice{node->light, probability};
}

double LightTree::ProbabilityOfNode(const R3::Point& p, const R3::Vector& N, int node) const {
  const int parent = nodes_[static_cast<std::size_t>(node)].parent;
  if (parent < 0) {
    if (has_lone_tree_) return 1;
    const Weights top = OfTreesAndInfinite(p, N);
    const auto tree = static_cast<std::size_t>(std::find(roots_.begin(), roots_.end(), node) - roots_.begin());
    return top.sum > 0 ? top.of[tree] / top.sum : 0;
  }
  const double of_parent = ProbabilityOfNode(p, N, parent);  // recursion no deeper than the tree, eight levels
  if (of_parent == 0) return 0;
  const Node& above = nodes_[static_cast<std::size_t>(parent)];
  const Weights weights = OfChildren(above, p, N);
  return weights.sum > 0 ? of_parent * (weights.of[static_cast<std::size_t>(node - above.first_child)] / weights.sum)
                         : 0;
}

double LightTree::Probability(const R3::Point& p, const R3::Vector& N, int light) const {
  const Slot slot = slots_[static_cast<std::size_t>(light)];
  if (slot.node >= 0) return ProbabilityOfNode(p, N, slot.node);
  if (slot.infinite < 0) return 0;
  const Weights top = OfTreesAndInfinite(p, N);
  return top.of[roots_.size()] / top.sum * among_infinite_->Probability(static_cast<std::size_t>(slot.infinite));
}

}  // namespace ray

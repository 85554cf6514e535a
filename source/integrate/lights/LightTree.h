#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "R3/Box.h"
#include "source/sample/DiscreteDistribution.h"
#include "source/scene/LightBound.h"

namespace ray {

/// Importance sampling of many lights: chooses a light for a point, important ones more often, so that one shadow ray
/// can represent all lights.
///
/// Lights at finite places are the leaves of trees of boxes. Each node is split up to four times into halves along the
/// longest side. On the way from a root a child is chosen by its importance
///
///   I = sum of powers / (ca + la d + qa d^2) * max(c, 0.1),
///
/// where d is the distance from p to the child's middle, at least its radius, and c the greatest cosine with N of a
/// place in the child's sphere. Lights with the same attenuation law have a tree of their own, and a tree is chosen
/// like a child: no sum of powers adds powers that cannot be compared. So a scene in another unit of length has the
/// same choices, up to rounding, and lights without attenuation count by their power at any distance. From the 15th law
/// on lights share a tree, in which a node's law and powers are correct at one distance, the radius of the whole tree.
///
/// Children without lights above the plane through p with normal N are skipped. The cosine is limited to at least 0.1
/// because highlights need not fade with it: no importance is below a tenth of that by power and distance alone.
/// Weights of the other children are at least 2^-24 of the largest, so every light of positive power that is not
/// entirely behind has a probability above 0. An infinite light's importance is its power, for all points.
///   source   Estevez, Kulla, Importance sampling of many lights with adaptive tree splitting (2018): the importance is
///            their section 3 without orientations of lights; sixteen children instead of two, because if p is near
///            both halves a node's middle is a poor estimate (for a ceiling of 1024 lights, a tenth of the variance)
class LightTree {
 public:
  explicit LightTree(std::vector<LightBound> lights);

  struct Choice {
    int light;           // index in the list from which the tree was built
    double probability;  // in (0, 1]
  };

  /// Chooses a light for the point p with unit normal N of the side to be lit. Returns std::nullopt if no light can
  /// light it: each has no power, or its sphere is not above the plane.
  ///   u      in [0, 1], uniform
  ///   time   O(log lights), unless most lights are in the very plane of p, where the side of each may be tested
  std::optional<Choice> Choose(const R3::Point& p, const R3::Vector& N, double u) const;

  /// Returns the probability that Choose returns `light`, bit for bit as in its Choice; 0 for one it never returns. The
  /// sum is 1 within 1e-12, or 0 if Choose returns std::nullopt.
  double Probability(const R3::Point& p, const R3::Vector& N, int light) const;

 private:
  static constexpr std::size_t most_children = 16;

  struct Node {
    R3::Box box;  // bounds of the lights' spheres, rounded outward
    R3::Point center;
    double radius = 0;
    double power = 0, ca = 0, la = 0, qa = 0;
    int first_child = 0, children = 0;  // 0 for leaves
    int parent = -1;
    int light = -1;  // for leaves
  };

  /// Non-negative weights of up to sixteen choices, the largest of them 1 within rounding; all 0 if there is no choice.
  struct Weights {
    std::array<double, most_children> of;  // the first `count` are set
    std::size_t count = 0;
    double sum = 0;
  };

  static Weights FromImportance(const std::array<double, most_children>& importance, std::size_t count);
  std::span<const Node> ChildrenOf(const Node& node) const {
    return std::span(nodes_).subspan(static_cast<std::size_t>(node.first_child),
                                     static_cast<std::size_t>(node.children));
  }
  /// Returns the importance of a node; `height` is that of the node's middle above the plane of p.
  static double Importance(const Node& node, const R3::Vector& to_center, double height);
  bool IsLit(const Node& node, const R3::Point& p, const R3::Vector& N, double height) const;
  double ImportanceIfLit(const Node& node, const R3::Point& p, const R3::Vector& N) const;
  /// Returns the weights of the trees in order, the last one that of the infinite lights.
  Weights OfTreesAndInfinite(const R3::Point& p, const R3::Vector& N) const;
  Weights OfChildren(const Node& node, const R3::Point& p, const R3::Vector& N) const;
  double ProbabilityOfNode(const R3::Point& p, const R3::Vector& N, int node) const;

  /// Adds a tree over some of the lights.
  void AddTree(const std::vector<LightBound>& lights, std::vector<int> finite);
  void Summarize(std::size_t root);
  void SummarizePowers(Node& node, double reference);

  std::vector<Node> nodes_;     // children after their parent
  std::vector<int> roots_;      // at most most_children - 1
  bool has_lone_tree_ = false;  // the only choice, whose children decide whether it is lit
  std::vector<int> infinite_;
  std::optional<DiscreteDistribution> among_infinite_;
  double infinite_power_ = 0;

  struct Slot {
    int node = -1;      // of a finite light
    int infinite = -1;  // of an infinite light
  };
  std::vector<Slot> slots_;  // for each light; neither is set for one without power
};

}  // namespace ray

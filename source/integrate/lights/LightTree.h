#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "R3/Box.h"
#include "source/sample/DiscreteDistribution.h"
#include "source/scene/LightBound.h"

namespace ray {

/// Importance sampling of many lights: chooses one for a point, those that matter there more often, so that one shadow
/// ray may stand for all of them.
///
/// Lights at finite places are the leaves of trees of boxes, each node cut up to four times in halves along the
/// longest side. On the way from a root a child is chosen by its importance
///
///   I = sum of powers / (ca + la d + qa d^2) * max(c, 0.1),
///
/// where d is the distance from p to the child's middle, at least its radius, and c the greatest cosine that a place in
/// the child's sphere makes with N. Lights that fall off by one law are a tree of their own, and which tree is chosen
/// like which child: no sum of powers adds what does not compare. So a scene measured in another unit of length has
/// the same choices, up to rounding, and lights without fall-off count by what they send however far they are. From
/// the 15th law on lights share a tree, where a node's law and powers are those that are right at one distance, the
/// radius of the whole tree.
///
/// Children none of whose lights reach above the plane through p with normal N are left out. The cosine is cut off at
/// 0.1 because highlights need not fade with it: no importance is below a tenth of what power and distance alone would
/// give. No child left in has a weight below 2^-24 of the largest, so every light of positive power that is not wholly
/// behind has a probability above 0. An infinite light's importance is its power, for all points alike.
///   source   Estevez, Kulla, Importance sampling of many lights with adaptive tree splitting (2018): the importance is
///            their section 3 without orientations of lights; sixteen children instead of two, because where p is near
///            both halves a node's middle says little (for a ceiling of 1024 lights, a tenth of the variance)
class LightTree {
 public:
  explicit LightTree(std::vector<LightBound> lights);

  struct Choice {
    int light;           // index in the list the tree was made from
    double probability;  // in (0, 1]
  };

  /// One light for the point p with unit normal N of the side that is to be lit. Nothing when no light can light it:
  /// each has no power, or its sphere is not above the plane.
  ///   u      in [0, 1], even
  ///   time   O(log lights), unless most lights are in the very plane of p, where each may be asked for its side
  std::optional<Choice> Choose(const R3::Point& p, const R3::Vector& N, double u) const;

  /// Probability that Choose gives `light`, bit for bit as in its Choice; 0 for one it never gives. The sum is 1
  /// within 1e-12, or 0 where Choose gives nothing.
  double Probability(const R3::Point& p, const R3::Vector& N, int light) const;

 private:
  static constexpr std::size_t most_children = 16;

  struct Node {
    R3::Box box;  // of the lights' spheres, rounded outward
    R3::Point center;
    double radius = 0;
    double power = 0, ca = 0, la = 0, qa = 0;
    int first_child = 0, children = 0;  // a leaf has none
    int parent = -1;
    int light = -1;  // a leaf's
  };

  /// Non-negative weights of up to sixteen choices, the largest of them 1 within rounding; all 0 where there is no
  /// choice.
  struct Weights {
    std::array<double, most_children> of;  // as many as `count` are set
    std::size_t count = 0;
    double sum = 0;
  };

  static Weights FromImportance(const std::array<double, most_children>& importance, std::size_t count);
  std::span<const Node> ChildrenOf(const Node& node) const {
    return std::span(nodes_).subspan(static_cast<std::size_t>(node.first_child),
                                     static_cast<std::size_t>(node.children));
  }
  /// `height` is that of the node's middle above the plane of p.
  static double Importance(const Node& node, const R3::Vector& to_center, double height);
  bool IsLit(const Node& node, const R3::Point& p, const R3::Vector& N, double height) const;
  double ImportanceIfLit(const Node& node, const R3::Point& p, const R3::Vector& N) const;
  /// Weights of the trees in order, the last one that of the infinite lights.
  Weights OfTreesAndInfinite(const R3::Point& p, const R3::Vector& N) const;
  Weights OfChildren(const Node& node, const R3::Point& p, const R3::Vector& N) const;
  double ProbabilityOfNode(const R3::Point& p, const R3::Vector& N, int node) const;

  /// A tree over some of the lights.
  void AddTree(const std::vector<LightBound>& lights, std::vector<int> finite);
  void Summarize(std::size_t root);
  void SummarizePowers(Node& node, double reference);

  std::vector<Node> nodes_;     // children after their parent
  std::vector<int> roots_;      // at most most_children - 1
  bool has_lone_tree_ = false;  // nothing to choose it from: its children say whether it is lit
  std::vector<int> infinite_;
  std::optional<DiscreteDistribution> among_infinite_;
  double infinite_power_ = 0;

  struct Slot {
    int node = -1;      // of a finite light
    int infinite = -1;  // of an infinite one
  };
  std::vector<Slot> slots_;  // of each light; neither for one without power
};

}  // namespace ray

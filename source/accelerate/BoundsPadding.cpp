#include "source/accelerate/BoundsPadding.h"

namespace ray {
namespace {

constexpr double rounding = R3::Gamma(64);

/// Returns the rounding of points up to distance + 2 reach from the world's origin when mapped into `frame`.
NodeBoundsPadding SeenFrom(const R3::Transform& frame, double reach) {
  const double stretch = MaxRowSum(frame.Inverse());
  return {2 * rounding * stretch, 2 * rounding * (stretch * 2 * reach + MaxTranslation(frame.Inverse()))};
}

/// Returns a bound on the distance that baking may have moved a shape, in its own frame.
double Baking(const R3::Transform& frame, double reach_within) {
  return rounding * MaxRowSum(frame.Inverse()) *
         (MaxRowSum(frame.Forward()) * reach_within + MaxTranslation(frame.Forward()));
}

}  // namespace

NodeBoundsPadding WorldBoundsPadding(const R3::Transform& frame, double reach) {
  const NodeBoundsPadding within = SeenFrom(frame, reach), own = SeenFrom({}, reach);
  const double stretch = MaxRowSum(frame.Forward());
  return {own.per_distance + stretch * within.per_distance, own.constant + stretch * within.constant};
}

std::vector<NodeBoundsPadding> PaddingOfNodes(const World& world) {
  const auto& nodes = world.Nodes();
  std::vector<NodeBoundsPadding> paddings(nodes.size());
  std::vector<double> reaches(nodes.size(), 0);  // in the world
  std::vector<std::uint32_t> parents(nodes.size(), 0);
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
    for (std::uint32_t k = 0; k < nodes[i].children; ++k) parents[nodes[i].first_child + k] = i;

  // Children come after their parents, so in reverse order every node is complete when it is reached.
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const FlatNode& flat = nodes[i];
    NodeBoundsPadding padding = paddings[i];  // the largest of the children's, in the node's own frame
    if (flat.instance >= 0) {
      reaches[i] = Reach(world.InWorld(flat.frame, flat.node->bounds));
      const R3::Transform& frame = world.Frames()[flat.frame];
      padding = SeenFrom(frame, reaches[i]);
      if (world.Instances()[static_cast<std::size_t>(flat.instance)].frame != flat.frame)
        padding.constant += Baking(frame, Reach(flat.node->bounds));
    } else if (!IsIdentity(flat.node->transform) || !(flat.node->motion == R3::Vector{})) {
      const NodeBoundsPadding own = SeenFrom(world.Frames()[nodes[parents[i]].frame], reaches[i]);
      const double stretch = MaxRowSum(flat.node->transform);
      padding = {own.per_distance + stretch * padding.per_distance, own.constant + stretch * padding.constant};
    }
    paddings[i] = padding;
    NodeBoundsPadding& above = paddings[parents[i]];
    above = {std::max(above.per_distance, padding.per_distance), std::max(above.constant, padding.constant)};
    reaches[parents[i]] = std::max(reaches[parents[i]], reaches[i]);
  }
  return paddings;
}

}  // namespace ray

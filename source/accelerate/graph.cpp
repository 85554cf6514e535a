#include <algorithm>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/BoundsPadding.h"
#include "source/accelerate/NearestHit.h"

namespace ray {
namespace {

// The scene graph itself, as in the course: a box around each node in its parent's coordinates (Rubin and Whitted, A
// 3-dimensional representation for fast rendering of complex scenes, 1980), children visited from front to back (Kay
// and Kajiya, Ray tracing complex scenes, 1986), and the last ray's hit tested first (Haines and Greenberg, The light
// buffer, 1986, for shadow rays).
class Graph : public Accelerator {
 public:
  Graph(const World& world, const AcceleratorSettings& settings)
      : Accelerator(world), settings_(settings), paddings_(PaddingOfNodes(world)) {}

 private:
  void Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const override {
    LocalRays local(world_, ray);
    std::optional<Workspace::LastHit> cached;
    if (settings_.last_hit && workspace.last_hit) {
      cached = workspace.last_hit;
      ++workspace.counts.cache_tests;
      nearest.Test(cached->instance, cached->element, local.In(world_.Instances()[cached->instance].frame),
                   workspace.counts);
      if (nearest.Best()) ++workspace.counts.cache_hits;
    }
    Visit(ray, local, workspace, nearest.Limit(), [&](std::uint32_t instance, const R3::Ray& seen, double& limit) {
      const int elements = world_.Instances()[instance].shape->Elements();
      for (int e = 0; e < elements; ++e)
        if (!(cached && cached->instance == instance && cached->element == e))
          nearest.Test(instance, e, seen, workspace.counts);
      limit = nearest.Limit();
      return false;
    });
    if (const auto& best = nearest.Best()) workspace.last_hit = {best->instance, best->element};
  }

  bool Any(const R3::Ray& ray, Workspace& workspace) const override {
    LocalRays local(world_, ray);
    const auto blocks = [&](std::uint32_t instance, int element, const R3::Ray& seen) {
      return IsInTheWay(world_, ray, seen, instance, element, workspace.counts);
    };
    std::optional<Workspace::LastHit> cached;
    if (settings_.last_hit && workspace.last_occluder) {
      cached = workspace.last_occluder;
      ++workspace.counts.cache_tests;
      if (blocks(cached->instance, cached->element, local.In(world_.Instances()[cached->instance].frame))) {
        ++workspace.counts.cache_hits;
        return true;
      }
    }
    bool occluded = false;
    Visit(ray, local, workspace, ray.t_max, [&](std::uint32_t instance, const R3::Ray& seen, double&) {
      const int elements = world_.Instances()[instance].shape->Elements();
      for (int e = 0; e < elements && !occluded; ++e) {
        if (cached && cached->instance == instance && cached->element == e) continue;
        occluded = blocks(instance, e, seen);
        if (occluded) workspace.last_occluder = {instance, e};
      }
      return occluded;
    });
    return occluded;
  }

  /// Traverses the nodes whose boxes the ray may meet before `limit`, nearest first if so set, and calls
  /// shape_reached(instance, local ray, limit) at each shape until it returns true.
  template <typename ShapeReached>
  void Visit(const R3::Ray& ray, LocalRays& local, Workspace& workspace, double limit,
             const ShapeReached& shape_reached) const {
    const double distance = MaxComponent(Abs(FromOrigin(ray.origin)));
    auto& stack = workspace.stack;
    stack.clear();
    PushIfReached(0, R3::BoxRay(ray), distance, limit, workspace);
    while (!stack.empty()) {
      const Workspace::StackEntry next = stack.back();
      stack.pop_back();
      if (next.entry > limit) continue;  // behind a hit found in the meantime
      ++workspace.counts.node_visits;
      const FlatNode& flat = world_.Nodes()[next.node];
      if (flat.instance >= 0) {
        const auto index = static_cast<std::uint32_t>(flat.instance);
        const Instance& instance = world_.Instances()[index];
        if (instance.is_bounded && !instance.is_repeated && shape_reached(index, local.In(instance.frame), limit))
          return;
        continue;
      }
      if (flat.children == 0) continue;
      const R3::BoxRay seen(local.In(flat.frame));
      const std::size_t first = stack.size();
      // Last child first, so that without sorting the stack returns them in file order.
      for (std::uint32_t k = flat.children; k-- > 0;)
        PushIfReached(flat.first_child + k, seen, distance, limit, workspace);
      if (settings_.front_to_back)
        std::sort(stack.begin() + static_cast<std::ptrdiff_t>(first), stack.end(), [](const auto& a, const auto& b) {
          return a.entry != b.entry ? a.entry > b.entry : a.node > b.node;
        });
    }
  }

  /// Pushes a node if its box is reached; `seen` is the ray in the frame of the node's box: its parent's.
  void PushIfReached(std::uint32_t node, R3::BoxRay seen, double distance, double limit, Workspace& workspace) const {
    if (!settings_.node_boxes && !settings_.front_to_back) {
      workspace.stack.push_back({seen.t_min, node});
      return;
    }
    ++workspace.counts.box_tests;
    seen.t_max = std::min(seen.t_max, limit);
    const NodeBoundsPadding& padding = paddings_[node];
    const auto entry =
        R3::Entry(world_.Nodes()[node].node->bounds, seen, padding.per_distance * distance + padding.constant);
    if (entry)
      workspace.stack.push_back({*entry, node});
    else if (!settings_.node_boxes)  // the box only affects the order
      workspace.stack.push_back({seen.t_min, node});
  }

  AcceleratorSettings settings_;
  std::vector<NodeBoundsPadding> paddings_;
};

}  // namespace

extern const AcceleratorKind graph_kind{
    "graph", "the scene graph itself: node boxes, front-to-back order, last-hit cache",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<Accelerator> {
      return std::make_unique<Graph>(world, settings);
    }};

}  // namespace ray

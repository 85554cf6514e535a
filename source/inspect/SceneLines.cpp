#include "source/inspect/SceneLines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Warp.h"

namespace ray {
namespace {

constexpr Rgba red{230, 60, 50, 255}, green{70, 190, 70, 255}, blue{70, 110, 240, 255};

void Add(Lines& lines, const DrawingSpace& space, const R3::Point& a, const R3::Point& b, const Rgba& color) {
  AddLine(lines, space.At(a), space.At(b), color);
}

/// One bit apart in their number, two corners share an edge.
void AddBox(Lines& lines, const DrawingSpace& space, const std::array<R3::Point, 8>& corners, const Rgba& color) {
  for (std::size_t i = 0; i < 8; ++i)
    for (const std::size_t bit : {1u, 2u, 4u})
      if (!(i & bit)) Add(lines, space, corners[i], corners[i | bit], color);
}

void AddBox(BoxLines& boxes, const DrawingSpace& space, const R3::Transform& frame, const R3::Box& box, int level) {
  if (boxes.boxes == most_boxes) {
    ++boxes.left_out;
    return;
  }
  std::array<R3::Point, 8> corners;
  for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = frame * box.Corner(i);
  AddBox(boxes.lines, space, corners, LevelColor(level));
  ++boxes.boxes;
}

/// Calls visit(node, frame of its parent, level) for each node. They lie level after level, parents before children.
template <typename Visit>
void ForEachNode(const World& world, const Visit& visit) {
  struct Above {
    std::uint32_t frame = 0;
    int level = 0;
  };
  const auto& nodes = world.Nodes();
  std::vector<Above> above(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::uint32_t k = 0; k < nodes[i].children; ++k)
      above[nodes[i].first_child + k] = {nodes[i].frame, above[i].level + 1};
    visit(*nodes[i].node, above[i].frame, above[i].level);
  }
}

/// Returns the brightest color of the same hue; white for black.
Rgba Bright(const R2::Color& color) {
  const double most = std::max({color.r, color.g, color.b});
  return most > 0 && std::isfinite(most) ? Shown(color / most) : Rgba{255, 255, 255, 255};
}

/// The light that a source emits in all directions.
struct Glow {
  R2::Color color;     // the brightest that was met
  R3::Vector towards;  // where more of it goes than elsewhere; 0 when it goes everywhere alike, else at most 1 long
};

Glow GlowOf(const Light& light, double distance) {
  constexpr int count = 512;  // directions: a spot light half a degree wide may fall between them
  const LightBound bound = light.Bound();
  Glow glow;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    // Evenly by area along a spiral: turned by the golden section from one to the next.
    const double turn = i * (std::numbers::phi - 1);
    const R3::Vector direction = R3::SampleUniformSphere({(i + 0.5) / count, turn - std::floor(turn)});
    const auto from = light.Illuminate(bound.center + distance * direction, {0.5, 0.5});
    if (!from) continue;
    const double strength = Luminance(from->irradiance);
    if (strength > Luminance(glow.color)) glow.color = from->irradiance;
    sum += strength;
    glow.towards = glow.towards + strength * direction;
  }
  glow.towards = sum > 0 ? glow.towards / sum : R3::Vector{};
  return glow;
}

void AddCircle(Lines& lines, const DrawingSpace& space, const R3::Point& center, const R3::Vector& a,
               const R3::Vector& b, const Rgba& color) {
  constexpr int pieces = 32;
  const auto at = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % pieces) / pieces;
    const auto [sine, cosine] = R1::SinCos(angle);
    return center + cosine * a + sine * b;
  };
  for (int i = 0; i < pieces; ++i) Add(lines, space, at(i), at(i + 1), color);
}

Lines LinesOf(const Light& light, const DrawingSpace& space) {
  constexpr double star_size = 0.03, arrow_length = 0.25;  // of the scene's radius
  constexpr std::uint8_t faint_alpha = 140;
  const double R = space.radius;
  Lines lines;
  const LightBound bound = light.Bound();
  if (bound.is_infinite) {
    const auto from = light.Illuminate(space.center, {0.5, 0.5});
    if (!from) return lines;
    const R3::Vector to_light = Unit(from->to_light);
    return ArrowAt(space.center + 1.5 * R * to_light, -arrow_length * R * to_light, space, Bright(from->irradiance));
  }
  const double size = star_size * R;
  const Glow glow = GlowOf(light, 2 * bound.radius + size);
  const Rgba color = Bright(glow.color);
  lines = CrossAt(bound.center, size, space, color);
  for (const R3::Vector& way : {R3::Vector{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}})
    Add(lines, space, bound.center - 0.35 * size * way, bound.center + 0.35 * size * way, color);
  if (bound.radius > 0) {
    const R3::Vector x{bound.radius, 0, 0}, y{0, bound.radius, 0}, z{0, 0, bound.radius};
    AddCircle(lines, space, bound.center, x, y, color);
    AddCircle(lines, space, bound.center, y, z, color);
    AddCircle(lines, space, bound.center, z, x, color);
  }
  constexpr double one_sided = 0.1;  // what goes everywhere alike sums to less
  if (Length(glow.towards) > one_sided)
    Append(lines, ArrowAt(bound.center, arrow_length * R * Unit(glow.towards), space, color));
  // So that one that is out of view is seen to be somewhere.
  if (Length(bound.center - space.center) > R)
    Add(lines, space, bound.center, space.center, {color[0], color[1], color[2], faint_alpha});
  return lines;
}

/// Makes boxes the fainter the more there are, so that the scene remains visible.
void Fade(BoxLines& boxes) {
  constexpr std::size_t most_opaque = 500;
  for (Vertex& v : boxes.lines) v.color = Faded(v.color, static_cast<std::size_t>(boxes.boxes), most_opaque);
}

}  // namespace

BoxLines NodeBoxLines(const World& world, const DrawingSpace& space, int level) {
  BoxLines boxes;
  ForEachNode(world, [&](const Node& node, std::uint32_t frame, int at) {
    if ((level == all_levels || level == at) && !node.bounds.IsEmpty())
      AddBox(boxes, space, world.Frames()[frame], node.bounds, at);
  });
  Fade(boxes);
  return boxes;
}

std::vector<std::size_t> ParentsOf(const World& world) {
  const auto& nodes = world.Nodes();
  std::vector<std::size_t> parents(nodes.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::uint32_t c = 0; c < nodes[i].children; ++c) parents[nodes[i].first_child + c] = i;
  return parents;
}

std::uint32_t FrameAround(const World& world, std::size_t node) {
  const std::size_t parent = ParentsOf(world)[node];
  return parent < world.Nodes().size() ? world.Nodes()[parent].frame : 0;
}

Lines NodeBoxOf(const World& world, const DrawingSpace& space, std::size_t node, const Rgba& color) {
  Lines lines;
  const auto& nodes = world.Nodes();
  if (nodes[node].node->bounds.IsEmpty()) return lines;
  const R3::Transform& frame = world.Frames()[FrameAround(world, node)];
  std::array<R3::Point, 8> corners;
  for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = frame * nodes[node].node->bounds.Corner(i);
  AddBox(lines, space, corners, color);
  return lines;
}

BoxLines AcceleratorBoxLines(const Accelerator& accelerator, const DrawingSpace& space, int level) {
  BoxLines boxes;
  for (int at = 0; at < accelerator.BoxLevels(); ++at)
    if (level == all_levels || level == at)
      for (const R3::Box& box : accelerator.BoxesAt(at)) AddBox(boxes, space, {}, box, at);
  Fade(boxes);
  return boxes;
}

Rgba LevelColor(int level) {
  // Hues turned by the golden section never come close to one of their last few; half as colorful as can be, so that
  // all stand out from dark and bright grounds.
  const double hue = 6 * std::fmod(0.08 + level * (std::numbers::phi - 1), 1.0);
  const auto channel = [&](double middle) {
    const double apart = std::abs(hue - middle), away = std::min(apart, 6 - apart);
    return 0.25 + 0.75 * std::clamp(2 - away, 0.0, 1.0);
  };
  return Shown({channel(0), channel(2), channel(4)});
}

Lines CameraLines(const Camera& camera, int width, int height, double distance, const DrawingSpace& space,
                  const Rgba& color) {
  Lines lines;
  const auto corner = [&](double x, double y) {
    return camera.eye + distance * camera.Through(x * width, y * height, width, height).direction;
  };
  const std::array corners{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
  for (std::size_t i = 0; i < 4; ++i) {
    Add(lines, space, camera.eye, corners[i], color);
    Add(lines, space, corners[i], corners[(i + 1) % 4], color);
  }
  const R3::Point top = corner(0.5, 1) + 0.25 * (corner(0.5, 1) - corner(0.5, 0));
  Add(lines, space, corner(0.35, 1), top, color);
  Add(lines, space, top, corner(0.65, 1), color);
  Add(lines, space, camera.eye, camera.eye + distance * camera.towards, color);
  return lines;
}

Lines LightLines(const Scene& scene, const DrawingSpace& space) {
  Lines lines;
  for (const auto& light : scene.lights)
    if (!light->IsBlack()) Append(lines, LinesOf(*light, space));
  return lines;
}

Lines SceneLineLines(const World& world, const DrawingSpace& space) {
  Lines lines;
  // Materials are inherited on the way down, as World does for shapes.
  const auto& nodes = world.Nodes();
  std::vector<int> materials(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = *nodes[i].node;
    if (node.material != Node::inherit) materials[i] = node.material;
    for (std::uint32_t k = 0; k < nodes[i].children; ++k) materials[nodes[i].first_child + k] = materials[i];
    if (!node.line) continue;
    const Material& material = world.scene().materials[static_cast<std::size_t>(materials[i])];
    const R3::Transform& frame = world.Frames()[nodes[i].frame];
    Add(lines, space, frame * node.line->start, frame * node.line->end, Bright(material.emission + material.kd));
  }
  return lines;
}

Lines AxesAt(const R3::Point& p, double size, const DrawingSpace& space) {
  Lines lines;
  Add(lines, space, p, p + R3::Vector{size, 0, 0}, red);
  Add(lines, space, p, p + R3::Vector{0, size, 0}, green);
  Add(lines, space, p, p + R3::Vector{0, 0, size}, blue);
  return lines;
}

Lines CrossAt(const R3::Point& p, double size, const DrawingSpace& space, const Rgba& color) {
  Lines lines;
  for (const R3::Vector& way : {R3::Vector{size, 0, 0}, {0, size, 0}, {0, 0, size}})
    Add(lines, space, p - way, p + way, color);
  return lines;
}

Lines ArrowAt(const R3::Point& p, const R3::Vector& way, const DrawingSpace& space, const Rgba& color) {
  Lines lines;
  Add(lines, space, p, p + way, color);
  if (way == R3::Vector{}) return lines;
  const R3::Tangents across = R3::TangentsOf(Unit(way));
  for (const R3::Vector& side : {across.first, -across.first, across.second, -across.second})
    Add(lines, space, p + way, p + 0.8 * way + 0.08 * Length(way) * side, color);
  return lines;
}

BoxLines LinesOfBoxes(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                      const DrawingSpace& space) {
  switch (overlays.boxes) {
    case SpaceOverlays::Boxes::nodes:
      return NodeBoxLines(world, space, overlays.box_level);
    case SpaceOverlays::Boxes::accelerator:
      return AcceleratorBoxLines(accelerator, space, overlays.box_level);
    case SpaceOverlays::Boxes::none:
      break;
  }
  return {};
}

std::string DescribeBoxes(const SpaceOverlays& overlays, const World& world, const Accelerator& accelerator,
                          const DrawingSpace& space) {
  if (overlays.boxes == SpaceOverlays::Boxes::none) return "no boxes";
  const std::string level =
      overlays.box_level == all_levels ? "of all levels" : "of level " + std::to_string(overlays.box_level);
  const BoxLines boxes = LinesOfBoxes(overlays, world, accelerator, space);
  return std::to_string(boxes.boxes) + (boxes.boxes == 1 ? " box" : " boxes") +
         (overlays.boxes == SpaceOverlays::Boxes::nodes ? " of nodes " : " of the accelerator ") + level +
         (boxes.left_out > 0 ? ", " + std::to_string(boxes.left_out) + " left out" : "");
}

}  // namespace ray

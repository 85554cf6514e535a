#include "source/inspect/DebugRays.h"

#include <algorithm>

#include "source/inspect/SceneLines.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr double ray_to_nowhere = 2;           // radii of the scene
constexpr std::size_t most_opaque_rays = 600;  // more would hide the scene
constexpr int fainter = 4;                     // times, rays that are not chosen
constexpr double normal_length = 0.04;         // likewise

ShownRays ShownAs(RayKind kind) {
  switch (kind) {
    case RayKind::camera:
      return ShownRays::camera;
    case RayKind::shadow:
      return ShownRays::shadow;
    case RayKind::reflection:
    case RayKind::diffuse:
      return ShownRays::reflection;
    case RayKind::transmission:
      return ShownRays::transmission;
  }
  return ShownRays::camera;
}

constexpr Rgba blocked{180, 40, 40, 255};  // a shadow ray beyond what blocks it
constexpr Rgba normal_color{255, 120, 220, 255}, foreign_color{255, 60, 200, 255};

Rgba ColorOf(RayKind kind) {
  switch (kind) {
    case RayKind::camera:
      return {240, 240, 240, 255};
    case RayKind::shadow:
      return {255, 220, 60, 255};
    case RayKind::reflection:
      return {80, 180, 255, 255};
    case RayKind::transmission:
      return {90, 230, 120, 255};
    case RayKind::diffuse:
      return {255, 150, 60, 255};
  }
  return {};
}

R3::Point StartOf(const RecordedRay& ray) { return ray.ray.At(ray.ray.t_min); }

R3::Point EndOf(const RecordedRay& ray, double scene_radius) {
  if (const auto end = ray.End()) return *end;
  return StartOf(ray) + ray_to_nowhere * scene_radius * Unit(ray.ray.direction);
}

/// Returns, for each ray, true for the chosen one and those that lead to it.
std::vector<bool> OnTheWay(const PixelTrace& trace, std::optional<std::size_t> chosen) {
  std::vector<bool> is(trace.rays.size());
  if (!chosen || *chosen >= trace.rays.size()) return is;
  for (int i = static_cast<int>(*chosen); i != RecordedRay::none; i = trace.rays[static_cast<std::size_t>(i)].parent)
    is[static_cast<std::size_t>(i)] = true;
  return is;
}

}  // namespace

std::vector<Rgba> ColorsOf(ShownRays kind) {
  std::vector<Rgba> colors;
  for (std::size_t i = 0; i < ray_kind_names.size(); ++i)
    if (ShownAs(static_cast<RayKind>(i)) == kind) colors.push_back(ColorOf(static_cast<RayKind>(i)));
  if (kind == ShownRays::shadow) colors.push_back(blocked);
  return colors;
}

Rgba ColorOfNormals() { return normal_color; }

Rgba ColorOfForeign() { return foreign_color; }

RenderSettings DebugRayCounts::Thinned(RenderSettings settings) const {
  settings.trace.shadow_samples = std::min(settings.trace.shadow_samples, shadow);
  return settings;
}

std::vector<PixelTrace> TraceGrid(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                  int spacing) {
  const PixelTracer tracer(world, accelerator, settings);
  std::vector<PixelTrace> traces;
  for (int row = 0; row < settings.height; row += spacing)
    for (int column = 0; column < settings.width; column += spacing) traces.push_back(tracer.Trace(column, row, 1));
  return traces;
}

Lines RayLines(const std::vector<PixelTrace>& traces, const DrawingSpace& space, const RayLook& look) {
  Lines lines;
  std::size_t rays = 0;
  for (const PixelTrace& trace : traces) rays += trace.rays.size();
  for (const PixelTrace& trace : traces) {
    const std::vector<bool> is_on_way = OnTheWay(trace, look.chosen);
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
      const RecordedRay& ray = trace.rays[i];
      const auto add = [&](const R3::Point& from, const R3::Point& to, Rgba color) {
        color = Faded(color, rays, most_opaque_rays);
        if (look.chosen && !is_on_way[i]) color[3] = static_cast<std::uint8_t>(color[3] / fainter);
        AddLine(lines, space.At(from), space.At(to), color);
      };
      if (!look.shows[static_cast<std::size_t>(ShownAs(ray.kind))]) continue;
      if (look.deepest >= 0 && ray.depth > look.deepest) continue;
      const R3::Point end = EndOf(ray, space.radius);
      add(StartOf(ray), end, ColorOf(ray.kind));
      if (ray.kind == RayKind::shadow && ray.at)
        add(end, ray.ray.t_max < R3::infinity ? ray.ray.At(1) : end + 0.2 * space.radius * Unit(ray.ray.direction),
            blocked);
      if (look.normals && ray.at && ray.kind != RayKind::shadow)
        add(end, end + normal_length * space.radius * AsVector(ray.at->shading_normal), normal_color);
    }
  }
  return lines;
}

Lines ForeignLines(const PixelTrace& foreign, const DrawingSpace& space, std::optional<std::size_t> differs) {
  Lines lines;
  for (const RecordedRay& ray : foreign.rays)
    AddLine(lines, space.At(StartOf(ray)), space.At(EndOf(ray, space.radius)), foreign_color);
  if (differs && *differs < foreign.rays.size())
    Append(lines,
           CrossAt(EndOf(foreign.rays[*differs], space.radius), normal_length * space.radius, space, foreign_color));
  return lines;
}

Lines ChosenRay(const PixelTrace& trace, const DrawingSpace& space, const RayLook& look) {
  Lines lines;
  if (!look.chosen || *look.chosen >= trace.rays.size()) return lines;
  const RecordedRay& ray = trace.rays[*look.chosen];
  const R3::Point end = EndOf(ray, space.radius);
  AddLine(lines, space.At(StartOf(ray)), space.At(end), ColorOf(ray.kind));
  if (ray.at) Append(lines, CrossAt(end, normal_length / 2 * space.radius, space, ColorOf(ray.kind)));
  return lines;
}

std::string RaysAsObj(const std::vector<PixelTrace>& traces, double scene_radius) {
  std::string text;
  std::size_t vertices = 0;
  const auto vertex = [&](const R3::Point& p) {
    text += "v " + ToText(p.x) + " " + ToText(p.y) + " " + ToText(p.z) + "\n";
    ++vertices;
  };
  for (std::size_t kind = 0; kind < ray_kind_names.size(); ++kind) {
    text += std::string("g ") + ray_kind_names[kind] + "\n";
    for (const PixelTrace& trace : traces)
      for (const RecordedRay& ray : trace.rays) {
        if (static_cast<std::size_t>(ray.kind) != kind) continue;
        vertex(StartOf(ray));
        vertex(EndOf(ray, scene_radius));
        text += "l " + std::to_string(vertices - 1) + " " + std::to_string(vertices) + "\n";
      }
  }
  return text;
}

}  // namespace ray

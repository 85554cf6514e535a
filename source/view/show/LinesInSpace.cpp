#include "source/view/show/Show.h"

#include <algorithm>
#include <array>

#include "source/view/commands/Commands.h"

namespace ray {
namespace {

constexpr double share_of_radius = 0.25;  // how far before it the image of the scene's camera is drawn
constexpr double cross_size = 8;          // pixels from the middle of a mark to its end
constexpr Rgba frustum_color{255, 255, 120, 255}, picked_color{255, 90, 90, 255}, chosen_color{255, 170, 60, 255};

}  // namespace

bool ShowsFrameOfQuad(const ViewerState& viewer) {
  const auto quad = viewer.Quad();
  return quad && !quad->FillsView(viewer.navigator.camera(), viewer.layout().view);
}

Lines MakeLines(const ViewerState& viewer) {
  const World& world = viewer.scene.world();
  const DrawingSpace& space = viewer.scene.Space();
  Lines lines = SceneLineLines(world, space);
  Append(lines, LinesOfBoxes(viewer.overlays, world, *viewer.scene.Loaded().accelerator, space).lines);
  if (viewer.selection.node && viewer.shows.panels)
    Append(lines, NodeBoxOf(world, space, *viewer.selection.node, chosen_color));
  if (viewer.overlays.lights) Append(lines, LightLines(viewer.scene.Parsed(), space));
  const auto frustum = [&](const Camera& camera, int width, int height, double distance) {
    Append(lines, CameraLines(camera, width, height, distance, space, frustum_color));
  };
  if (viewer.overlays.camera)
    frustum(viewer.scene.Parsed().camera, viewer.screen.size.width, viewer.screen.size.height,
            share_of_radius * space.radius);
  if (ShowsFrameOfQuad(viewer)) {
    const auto quad = viewer.Quad();
    const RenderSettings& traced = viewer.traced.Trace()->Settings();
    frustum(quad->camera(), traced.width, traced.height, quad->Distance());
  }
  // Each by itself: what fades among many rays of the grid must not take those of a pixel along.
  if (viewer.rays.ShowsGrid()) Append(lines, RayLines(viewer.rays.Grid(), space, viewer.rays.Look().WithoutChoice()));
  if (viewer.rays.Pixel()) Append(lines, RayLines({*viewer.rays.Pixel()}, space, viewer.rays.Look()));
  if (!viewer.rays.Foreign().empty()) {
    const auto& difference = viewer.rays.Difference();
    Append(lines, ForeignLines(AsTrace(viewer.rays.Foreign(), space.radius), space,
                               difference ? std::optional(difference->foreign) : std::nullopt));
  }
  return lines;
}

Lines MakeMarks(const ViewerState& viewer) {
  Lines lines;
  const Camera& camera = viewer.navigator.camera();
  const auto size_at = [&](const R3::Point& p) {
    return cross_size * std::max(0.0, DepthOf(camera, p)) * 2 * camera.HalfWidth() / viewer.layout().view.width;
  };
  if (const auto& pivot = viewer.navigator.Pivot())
    Append(lines, AxesAt(*pivot, size_at(*pivot), viewer.scene.Space()));
  if (viewer.shows.panels || viewer.editor.IsDragging())
    Append(lines, viewer.editor.Marks(viewer.scene.Space(), size_at));
  if (const auto& pick = viewer.selection.pick; pick && pick->point)
    Append(lines, CrossAt(*pick->point, size_at(*pick->point), viewer.scene.Space(), picked_color));
  return lines;
}

Lines FrameOfCrop(const ViewerState& viewer) {
  const Camera& camera = viewer.navigator.camera();
  const R3::Box box = BoxOfDrawing(viewer);
  const double depth = box.IsEmpty() ? 0 : DepthOf(camera, box.Center()), radius = viewer.scene.Space().radius;
  const auto corner = [&](double x, double y) {
    const R3::Ray ray = camera.Through(x, y, viewer.screen.size.width, viewer.screen.size.height);
    const double distance = std::max(depth, radius) / Dot(ray.direction, camera.towards);
    return viewer.scene.Space().At(ray.At(distance));
  };
  const double left = viewer.crop->x0, bottom = viewer.crop->y0, right = viewer.crop->x1, top = viewer.crop->y1;
  const std::array corners{corner(left, bottom), corner(right, bottom), corner(right, top), corner(left, top)};
  Lines lines;
  for (std::size_t i = 0; i < corners.size(); ++i)
    AddLine(lines, corners[i], corners[(i + 1) % corners.size()], chosen_color);
  return lines;
}

R3::Box BoxOfDrawing(const ViewerState& viewer) {
  R3::Box box = BoxToFrame(viewer);
  const bool has_rays = viewer.rays.ShowsGrid() || viewer.rays.Pixel(),
             has_planes = !viewer.scene.world().Unbounded().empty();
  if ((has_rays || has_planes) && !box.IsEmpty()) {  // they go beyond the scene
    const double reach = (has_planes ? times_the_scene : 2) * box.Radius();
    box = {box.low - R3::Vector{reach, reach, reach}, box.high + R3::Vector{reach, reach, reach}};
  }
  const auto quad = viewer.Quad();
  if (!quad) return box;
  box.Extend(quad->camera().eye);
  for (const R3::Point& corner : quad->Corners()) box.Extend(corner);
  return box;
}

}  // namespace ray

#include "source/view/commands/Commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "source/text/Words.h"

namespace ray {
namespace {

constexpr const char* no_rays = "no rays are shown; press G or right-click a pixel first";

/// Returns the settings for a grid of rays: those of the rendered image, or of the view.
RenderSettings SettingsOfGrid(const ViewerState& viewer) {
  return viewer.traced.Trace() ? viewer.traced.Trace()->Settings() : viewer.SettingsOfImage();
}

/// Returns the pixel of the rendered image at that place of its quad.
std::optional<TracedQuad::Meeting> PixelOnQuad(const ViewerState& viewer, const R2::Point& position) {
  const auto quad = viewer.Quad();
  if (!quad) return {};
  const auto ray = viewer.RayAt(position);
  const auto meeting = ray ? quad->MeetingWith(*ray) : std::nullopt;
  if (!meeting) return {};
  // What stands before the quad is meant rather than it.
  const auto nearer = viewer.PointAt(position);
  if (nearer && Length(*nearer - ray->origin) < Length(ray->At(meeting->t) - ray->origin)) return {};
  return meeting;
}

/// Shows the cross section again after its plane has changed.
void ShowPlane(ViewerState& viewer) {
  viewer.section_pane.takes_arrows = true;
  viewer.section_pane.drawing.reset();
  if (viewer.section.IsShown()) MakeSection(viewer);
  viewer.notices.Show("cross section: " + viewer.section.Describe(viewer.screen.size.height));
}

void ReportPixel(ViewerState& viewer) {
  viewer.section_pane.takes_arrows = false;
  const PixelTrace& pixel = *viewer.rays.Pixel();
  viewer.host.Print(RayTree(pixel, viewer.scene.world(), viewer.rays.PixelSettings()));
  const auto& difference = viewer.rays.Difference();
  const std::string found = viewer.rays.Foreign().empty() ? std::string()
                            : difference ? "; the first of the other rays that differs: " + difference->text
                                         : "; the other rays are as ours";
  if (!found.empty()) viewer.host.Print(found.substr(2));
  viewer.notices.Show("pixel " + std::to_string(pixel.column) + " " + std::to_string(pixel.row) + ", " +
                      Counted(pixel.rays.size(), "ray") + viewer.rays.WhatIsLeftOut() + found);
  viewer.notices.RedrawLines();
}

}  // namespace

void ToggleGrid(ViewerState& viewer) {
  viewer.notices.RedrawLines();
  if (viewer.rays.ShowsGrid()) {
    viewer.rays.ToggleGrid();
    return viewer.notices.Show("rays off");
  }
  viewer.rays.TraceGrid(viewer.scene.Loaded(), SettingsOfGrid(viewer));
  viewer.notices.Show("rays of " + Counted(viewer.rays.Grid().size(), "pixel") + "; F2 to F5 choose kinds, N bounces");
}

void DebugPixelAt(ViewerState& viewer, const R2::Point& position) {
  if (const auto pixel = viewer.FlatJob() ? std::nullopt : PixelOnQuad(viewer, position)) {
    viewer.rays.TracePixel(viewer.scene.Loaded(), viewer.traced.Trace()->Settings(), pixel->column, pixel->row);
  } else {
    const R2::Point p = viewer.InShownImage(position);
    const RenderSettings settings = viewer.SettingsOfShownImage();
    if (p.x < 0 || p.y < 0 || p.x >= settings.width || p.y >= settings.height) return;
    viewer.rays.TracePixel(viewer.scene.Loaded(), settings, static_cast<int>(p.x), static_cast<int>(p.y));
  }
  ReportPixel(viewer);
}

void ShowForeignRays(ViewerState& viewer, const std::string& file, ForeignRays foreign) {
  viewer.notices.RedrawLines();
  const RenderSettings settings = viewer.SettingsOfView();
  const auto pixel = PixelOf(foreign, viewer.navigator.camera(), settings);
  const std::string count = Counted(foreign.rays.size(), "ray");
  viewer.rays.SetForeign(std::move(foreign.rays));
  if (!pixel)
    return viewer.notices.Show(count + " of " + file +
                               "; none of them is a camera ray through the image, so right-click its pixel");
  viewer.rays.TracePixel(viewer.scene.Loaded(), settings, pixel->column, pixel->row);
  ReportPixel(viewer);
}

void MoveByArrow(ViewerState& viewer, int right, int up) {
  if (viewer.section_pane.takes_arrows) {
    MoveSection(viewer, up);
  } else if (viewer.rays.StepPixel(viewer.scene.Loaded(), right, up)) {
    ReportPixel(viewer);
  } else {
    viewer.notices.Show(viewer.rays.Pixel() ? "the border of the image" : "right-click a pixel first, or press X");
  }
}

void SaveRays(ViewerState& viewer) {
  const auto shown = viewer.rays.Shown();
  if (shown.empty()) return viewer.notices.Show(no_rays);
  viewer.notices.Show(viewer.host.SaveRays(RaysAsObj(shown, viewer.scene.Space().radius)));
}

void StepBounce(ViewerState& viewer, int by) {
  if (viewer.rays.Shown().empty()) return viewer.notices.Show(no_rays);
  viewer.rays.StepBounce(by);
  viewer.notices.RedrawLines();
  const int deepest = viewer.rays.Look().deepest;
  viewer.notices.Show(deepest < 0 ? "rays of all bounces" : "rays of up to " + std::to_string(deepest) + " bounces");
}

void ForgetPixel(ViewerState& viewer) {
  if (!viewer.rays.Pixel()) return viewer.notices.Show("no pixel's rays are shown; right-click a pixel first");
  viewer.rays.ForgetPixel();
  viewer.notices.RedrawLines();
  viewer.notices.Show("the pixel's rays are cleared");
}

void ChooseRay(ViewerState& viewer, std::optional<std::size_t> ray) {
  if (!viewer.rays.Pixel()) return;
  viewer.rays.Choose(ray);
  viewer.notices.RedrawLines();
}

void ToggleRays(ViewerState& viewer, ShownRays kind) {
  constexpr std::array names{"camera rays", "shadow rays", "reflected and scattered rays", "transmitted rays"};
  static_assert(names.size() == shown_ray_kinds);
  const auto i = static_cast<std::size_t>(kind);
  viewer.rays.Toggle(kind);
  viewer.section_pane.drawing.reset();
  viewer.notices.RedrawLines();
  viewer.notices.Show(std::string(names[i]) + (viewer.rays.Look().shows[i] ? " on" : " off"));
}

void ToggleNormals(ViewerState& viewer) {
  viewer.rays.ToggleNormals();
  viewer.notices.RedrawLines();
  viewer.notices.Show(std::string("normals at hit points") + (viewer.rays.Look().normals ? " on" : " off"));
}

void SetDebugRays(ViewerState& viewer, const DebugRayCounts& counts) {
  viewer.rays.SetCounts(counts);
  if (viewer.rays.ShowsGrid()) viewer.rays.TraceGrid(viewer.scene.Loaded(), SettingsOfGrid(viewer));
  viewer.rays.TraceAgain(viewer.scene.Loaded());
  viewer.section_pane.drawing.reset();
  viewer.notices.RedrawLines();
  viewer.notices.Show(Counted(static_cast<std::uint64_t>(counts.camera), "camera ray") + " per pixel, " +
                      Counted(static_cast<std::uint64_t>(counts.shadow), "shadow ray") +
                      " per light; cut: " + Counted(static_cast<std::uint64_t>(counts.in_cut), "pixel"));
}

void ToggleSection(ViewerState& viewer) {
  viewer.section.Toggle();
  viewer.section_pane.takes_arrows = viewer.section.IsShown();
  viewer.section_pane.drawing.reset();
  viewer.notices.Show(viewer.section.IsShown() ? "cross section on" : "cross section off");
}

void ShowSection(ViewerState& viewer, SlicePlane plane) {
  if (!viewer.section.IsShown()) ToggleSection(viewer);
  while (viewer.section.Plane() != plane) NextPlane(viewer);
}

void NextPlane(ViewerState& viewer) {
  viewer.section.NextPlane();
  ShowPlane(viewer);
}

void FollowByCut(ViewerState& viewer) {
  const R2::Point& pointer = viewer.screen.pointer;
  if (!viewer.section.IsShown() || viewer.FlatJob() || pointer.x < 0 || pointer.x >= viewer.layout().view.width) return;
  const double y = viewer.InImage(pointer).y;
  if (!(y >= 0 && y < viewer.screen.size.height) || !viewer.section.MoveTo(static_cast<int>(y))) return;
  viewer.section_pane.drawing.reset();
  viewer.notices.Redraw();
}

void MoveSection(ViewerState& viewer, int by) {
  viewer.section.Move(by, viewer.screen.size.height);
  ShowPlane(viewer);
}

int LineWidth(const ViewerState& viewer) { return std::max(1, static_cast<int>(std::lround(viewer.screen.scale))); }

void MakeSection(ViewerState& viewer) {
  const PanelTheme theme = viewer.panels->Look().theme;
  if (viewer.section_pane.drawing && viewer.section_pane.size == viewer.layout().section &&
      viewer.section_pane.theme == theme)
    return;
  viewer.section_pane.size = viewer.layout().section;
  viewer.section_pane.theme = theme;
  viewer.section.Cut(viewer.scene.Loaded(), viewer.SettingsOfImage(), viewer.navigator.Center(),
                     viewer.section_pane.size, viewer.rays.Counts());
  SliceAxes drawing = viewer.section.Drawing(viewer.scene.Loaded(), viewer.rays.Look().WithoutChoice(),
                                             viewer.panels->Letters(), LineWidth(viewer));
  if (theme == PanelTheme::light)
    for (Vertex& vertex : drawing.lines) vertex.color = LineOnLight(vertex.color);
  viewer.section_pane.drawing = std::make_shared<const SliceAxes>(std::move(drawing));
}

std::string TextOfSection(const ViewerState& viewer) {
  if (!viewer.section_pane.drawing || !viewer.layout().IsOnSection(viewer.screen.pointer)) return {};
  const Layout layout = viewer.layout();
  return viewer.section.DescribePlace(layout.OnSection(viewer.screen.pointer),
                                      viewer.section_pane.measured_from
                                          ? std::optional(layout.OnSection(*viewer.section_pane.measured_from))
                                          : std::nullopt);
}

}  // namespace ray

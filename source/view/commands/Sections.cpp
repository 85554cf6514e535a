#include "source/view/commands/Sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ray {

void ToggleSection(ViewerState& viewer) {
  viewer.section.Toggle();
  viewer.arrows_move_section = viewer.section.IsShown();
  viewer.section_drawing.reset();
  viewer.notices.Tell(viewer.section.IsShown() ? "cross section on" : "cross section off");
}

void ShowSection(ViewerState& viewer, SlicePlane plane) {
  if (!viewer.section.IsShown()) ToggleSection(viewer);
  while (viewer.section.Plane() != plane) NextPlane(viewer);
}

void NextPlane(ViewerState& viewer) {
  viewer.section.NextPlane();
  viewer.arrows_move_section = true;
  viewer.section_drawing.reset();
  if (viewer.section.IsShown()) MakeSection(viewer);
  viewer.notices.Tell("cross section: " + viewer.section.Describe(viewer.size.height));
}

void MoveSection(ViewerState& viewer, int by) {
  viewer.section.Move(by, viewer.size.height);
  viewer.arrows_move_section = true;
  viewer.section_drawing.reset();
  if (viewer.section.IsShown()) MakeSection(viewer);
  viewer.notices.Tell("cross section: " + viewer.section.Describe(viewer.size.height));
}

int LineWidth(const ViewerState& viewer) { return std::max(1, static_cast<int>(std::lround(viewer.scale))); }

void MakeSection(ViewerState& viewer) {
  const PanelTheme theme = viewer.panels->Look().theme;
  if (viewer.section_drawing && viewer.section_size == viewer.layout().section && viewer.section_theme == theme) return;
  viewer.section_size = viewer.layout().section;
  viewer.section_theme = theme;
  viewer.section.Cut(viewer.scene.Loaded(), viewer.SettingsOfView(), viewer.navigator.Center(), viewer.section_size,
                     viewer.rays.Counts());
  SliceAxes drawing =
      viewer.section.Drawing(viewer.scene.Loaded(), viewer.rays.Look().WithoutChoice(), viewer.panels->Letters(),
                             LineWidth(viewer));
  if (theme == PanelTheme::light)
    for (Vertex& vertex : drawing.lines) vertex.color = LineOnLight(vertex.color);
  viewer.section_drawing = std::make_shared<const SliceAxes>(std::move(drawing));
}

std::string TextOfSection(const ViewerState& viewer) {
  if (!viewer.section_drawing || !viewer.layout().IsOnSection(viewer.pointer)) return {};
  const Layout layout = viewer.layout();
  return viewer.section.Tell(
      layout.OnSection(viewer.pointer),
      viewer.measured_from ? std::optional(layout.OnSection(*viewer.measured_from)) : std::nullopt);
}

}  // namespace ray

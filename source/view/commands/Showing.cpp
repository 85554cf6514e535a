#include "source/view/commands/Commands.h"

#include <algorithm>

namespace ray {
namespace {

std::string BoxesOf(const ViewerState& viewer) {
  return DescribeBoxes(viewer.overlays, viewer.scene.world(), *viewer.scene.Loaded().accelerator, viewer.scene.Space());
}

}  // namespace

void Toggle(ViewerState& viewer, const char* what, bool SpaceOverlays::*shows) {
  viewer.overlays.*shows = !(viewer.overlays.*shows);
  viewer.notices.RedrawLines();
  viewer.notices.Show(std::string(what) + (viewer.overlays.*shows ? " on" : " off"));
}

void Peel(ViewerState& viewer) {
  if (viewer.shows.help) return ToggleHelp(viewer);
  if (viewer.reader.IsBusy()) {
    viewer.notices.Show("stopped " + viewer.reader.Describe());
    return viewer.reader.Stop();
  }
  if (viewer.flat.IsShown()) return ToggleFlat(viewer);
  if (viewer.crop) return ClearCrop(viewer);
  if (viewer.selection.pick) {
    viewer.selection.pick.reset();
    ChooseNode(viewer, {});
    return viewer.notices.Show("pick forgotten");
  }
  if (viewer.section.IsShown()) return ToggleSection(viewer);
  if (!viewer.scene.Mistakes().empty() && viewer.scene.MistakenFile() != viewer.settings.scene) {
    viewer.scene.ForgetMistakes();
    return viewer.notices.Show("mistakes of " + viewer.scene.MistakenFile() + " forgotten");
  }
  viewer.notices.Show(viewer.traced.StopTrace() || viewer.traced.StopLive() ? "rendering is being stopped"
                                                                            : "nothing to close; Q quits");
}

void Quit(ViewerState& viewer) {
  if (!viewer.editor.MayLose("quit")) return;
  if (viewer.traced.IsTracing() &&
      !viewer.notices.Confirms("still rendering; Q, or closing the window, once more quits without saving"))
    return;
  viewer.is_closed = true;
}

void ToggleLights(ViewerState& viewer) {
  viewer.overlays.lights = !viewer.overlays.lights;
  viewer.notices.RedrawLines();
  if (!viewer.overlays.lights) return viewer.notices.Show("lights off");
  int lights = 0, in_view = 0, far = 0;
  const DrawingSize view = viewer.layout().view;
  for (const auto& light : viewer.scene.Parsed().lights) {
    if (light->IsBlack()) continue;
    ++lights;
    if (light->Bound().is_infinite) {
      ++far;
      continue;
    }
    const auto pixel = PixelOf(viewer.navigator.camera(), light->Bound().center, view);
    in_view += pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < view.width && pixel->y < view.height;
  }
  const int outside = lights - far - in_view;
  viewer.notices.Show(std::to_string(lights) + (lights == 1 ? " light" : " lights") +
                      (outside > 0 ? ", " + std::to_string(outside) + " out of view; F frames them" : ""));
}

void CycleBoxes(ViewerState& viewer) {
  using Boxes = SpaceOverlays::Boxes;
  const Boxes boxes = viewer.overlays.boxes;
  ShowBoxes(viewer, boxes == Boxes::none ? Boxes::nodes : boxes == Boxes::nodes ? Boxes::accelerator : Boxes::none);
}

void ShowBoxes(ViewerState& viewer, SpaceOverlays::Boxes boxes) {
  viewer.overlays.boxes = boxes;
  viewer.notices.RedrawLines();
  viewer.notices.Show(BoxesOf(viewer));
}

void ChangeBoxLevel(ViewerState& viewer, int by) {
  if (viewer.overlays.boxes == SpaceOverlays::Boxes::none) viewer.overlays.boxes = SpaceOverlays::Boxes::nodes;
  constexpr int deepest = 1 << 20;
  viewer.overlays.box_level = std::clamp(viewer.overlays.box_level + by, all_levels, deepest);
  viewer.notices.RedrawLines();
  viewer.notices.Show(BoxesOf(viewer));
}

void ToggleHelp(ViewerState& viewer) {
  viewer.shows.help = !viewer.shows.help;
  viewer.panels->SetParts(viewer.Parts());
  viewer.notices.Show(viewer.shows.help ? "help; type to search it, Escape closes it" : "help closed");
}

void ShowPanels(ViewerState& viewer, const PanelSettings& look) {
  viewer.panels->SetLook(look);
  viewer.shows.panels = true;
  viewer.panels->SetParts(viewer.Parts());
  viewer.section_pane.drawing.reset();
  viewer.notices.RedrawLines();
}

void TogglePanels(ViewerState& viewer) {
  if (viewer.shows.panels) {
    viewer.shows.panels = false;
    viewer.panels->SetParts(viewer.Parts());
    viewer.notices.RedrawLines();
    return viewer.notices.Show("panels off");
  }
  ShowPanels(viewer, viewer.panels->Look());
  viewer.notices.Show("panels; Tab hides them");
}

void SetPanelLook(ViewerState& viewer, const PanelSettings& look) {
  viewer.panels->SetLook(look);
  viewer.section_pane.drawing.reset();
  viewer.notices.Redraw();
}

void ChooseNode(ViewerState& viewer, std::optional<std::size_t> node) {
  viewer.selection.node = node;
  viewer.notices.RedrawLines();
}

void PickAt(ViewerState& viewer, const R2::Point& position) {
  const RenderSettings settings = viewer.SettingsOfShownImage();
  if (position.x < 0 || position.y < 0 || position.x >= settings.width || position.y >= settings.height) return;
  viewer.selection.pick = PickPixel(viewer.scene.world(), *viewer.scene.Loaded().accelerator, settings,
                                    static_cast<int>(position.x), static_cast<int>(position.y));
  for (const std::string& line : viewer.selection.pick->text) viewer.host.Print(line);
  viewer.selection.node.reset();
  const auto& nodes = viewer.scene.world().Nodes();
  for (std::size_t i = 0; viewer.selection.pick->point && i < nodes.size(); ++i)
    if (nodes[i].instance == static_cast<std::int32_t>(viewer.selection.pick->instance)) viewer.selection.node = i;
  viewer.notices.RedrawLines();
}

void FocusUnderPointer(ViewerState& viewer) { viewer.editor.FocusOn(viewer.PointAt(viewer.screen.pointer)); }

}  // namespace ray

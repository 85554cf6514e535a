#include "source/view/commands/Commands.h"

#include <numbers>

#include "R1/Elementary.h"
#include "source/inspect/SceneLines.h"
#include "source/scene/CameraText.h"
#include "source/text/NumberText.h"

namespace ray {

void PrintCamera(ViewerState& viewer) {
  const std::string line = CameraLine(viewer.navigator.camera());
  viewer.host.Print(line);
  viewer.host.SetClipboard(line + "\n");
  viewer.notices.Show("camera printed and copied to the clipboard");
}

R3::Box BoxToFrame(const ViewerState& viewer) {
  R3::Box box = viewer.scene.Parsed().root.bounds;
  if (!viewer.overlays.lights) return box;
  for (const auto& light : viewer.scene.Parsed().lights) {
    const LightBound bound = light->Bound();
    const R3::Vector reach{bound.radius, bound.radius, bound.radius};
    if (!light->IsBlack() && !bound.is_infinite) box.Extend(bound.center - reach), box.Extend(bound.center + reach);
  }
  return box;
}

void FrameScene(ViewerState& viewer) {
  const R3::Box box = BoxToFrame(viewer);
  if (box.IsEmpty()) return viewer.notices.Show("the scene is empty and cannot be framed");
  viewer.navigator.Frame(box);
  viewer.notices.Show(viewer.overlays.lights ? "the whole scene and its lights are framed"
                                             : "the whole scene is framed");
}

void Widen(ViewerState& viewer, double factor) {
  viewer.navigator.Widen(factor);
  constexpr double degrees = 180 / std::numbers::pi;
  const double angle = 2 * degrees * R1::Atan(viewer.navigator.camera().HalfWidth());
  viewer.notices.Show("field of view " + Fixed(angle, 1) + " degrees across");
}

void LookAlong(ViewerState& viewer, const R3::Vector& towards, const R3::Vector& up, const std::string& name) {
  viewer.navigator.LookAlong(towards, up);
  viewer.notices.Show("looking along " + name + " at the " + (viewer.navigator.Pivot() ? "pivot" : "scene"));
}

void ToggleTurntable(ViewerState& viewer) {
  viewer.navigator.ToggleTurntable();
  viewer.notices.Show(viewer.navigator.IsTurntable() ? "rotates as a turntable" : "rotates freely");
}

void GoBack(ViewerState& viewer) {
  viewer.notices.Show(viewer.navigator.Back() ? "back to the view before" : "there is no view before");
}

void GoForward(ViewerState& viewer) {
  viewer.notices.Show(viewer.navigator.Forward() ? "on to the view after" : "there is no view after");
}

void GoToSceneCamera(ViewerState& viewer) {
  viewer.navigator.Go(viewer.scene.Parsed().camera);
  viewer.notices.Show("back at the scene's camera");
}

void SetPivot(ViewerState& viewer, const std::optional<R3::Point>& pivot) {
  viewer.navigator.SetPivot(pivot);
  viewer.notices.Show(pivot ? "pivot set" : "pivot reset to the center of the scene");
  viewer.notices.RedrawLines();
}

void FramePicked(ViewerState& viewer) {
  if (!viewer.selection.pick || !viewer.selection.pick->point)
    return viewer.notices.Show("nothing is picked; click an object first");
  const Instance& instance = viewer.scene.world().Instances()[viewer.selection.pick->instance];
  if (!instance.is_bounded) return viewer.notices.Show("it is infinite and cannot be framed");
  const R3::Box box = viewer.scene.world().InWorld(instance.frame, R3::Bounds(*instance.shape));
  viewer.navigator.SetPivot(viewer.selection.pick->point);
  viewer.navigator.Frame(box);
  viewer.notices.Show("the picked object is framed");
}

void FrameChosenNode(ViewerState& viewer) {
  if (!viewer.selection.node) return;
  const World& world = viewer.scene.world();
  const R3::Box box =
      world.InWorld(FrameAround(world, *viewer.selection.node), world.Nodes()[*viewer.selection.node].node->bounds);
  if (box.IsEmpty()) return viewer.notices.Show("it is infinite or empty and cannot be framed");
  viewer.navigator.Frame(box);
}

void KeepBookmark(ViewerState& viewer, int digit) {
  viewer.bookmarks.ReadAgain();
  viewer.bookmarks.Set(digit, viewer.navigator.camera());
  const std::string problem = viewer.bookmarks.File().empty()
                                  ? "the scene is no file for them to be kept beside"
                                  : viewer.host.SaveText(viewer.bookmarks.File(), viewer.bookmarks.Text());
  viewer.notices.Show("bookmark " + std::to_string(digit) +
                      (problem.empty() ? " saved" : " lasts for this session only: " + problem));
}

void RecallBookmark(ViewerState& viewer, int digit) {
  const auto camera = viewer.bookmarks.Find(digit);
  const std::string name = "bookmark " + std::to_string(digit);
  if (!camera)
    return viewer.notices.Show("there is no " + name + "; Control+" + std::to_string(digit) + " saves this view as it");
  viewer.navigator.Go(*camera);
  viewer.notices.Show("at " + name);
}

}  // namespace ray

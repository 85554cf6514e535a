#include "source/view/PointerInput.h"

#include <utility>

#include "R1/Elementary.h"
#include "source/view/commands/Commands.h"

namespace ray {
namespace {

constexpr double click_reach = 4;          // pixels that a click may move
constexpr double double_click_time = 0.4;  // seconds
constexpr Modifiers of_moving{true, true};

double Distance(const R2::Point& a, const R2::Point& b) { return R1::Hypot(a.x - b.x, a.y - b.y); }

Navigator::PointAt PointFinder(const ViewerState& viewer) {
  return [&viewer](const R2::Point& position) { return viewer.PointAt(position); };
}

}  // namespace

void PointerInput::On(const ButtonEvent& event, ViewerState& viewer) {
  if (event.is_pressed) {
    if (!press_) Begin(event, viewer);  // else it is a second button while one is held
    return;
  }
  if (!IsHeldBy(event.button)) return;
  const bool is_click = press_->is_click && press_->what != Drags::section;
  viewer.editor.EndDrag();
  if (viewer.section_pane.measured_from) viewer.notices.Redraw();
  viewer.section_pane.measured_from.reset();
  press_.reset();
  viewer.navigator.EndDrag();
  if (is_click) OnClick(event, viewer);
}

void PointerInput::Begin(const ButtonEvent& event, ViewerState& viewer) {
  press_ = Press{event.button, {event.x, event.y}, Drags::view};
  if (viewer.layout().IsOnSection(press_->at)) {
    press_->what = Drags::section;
    viewer.section_pane.measured_from = press_->at;
  } else if (viewer.FlatJob()) {
    press_->what = TakesSlider(viewer, event) ? Drags::slider : Drags::flat;
  } else if (event.button == Button::left && event.modifiers == of_moving) {
    press_->what = Drags::chosen;
    if (const auto ray = viewer.RayAt(press_->at)) viewer.editor.BeginDrag(*ray);
  } else if (event.button == Button::right && event.modifiers.control) {
    press_->what = Drags::crop;
  } else {
    viewer.navigator.BeginDrag(event, PointFinder(viewer));
  }
}

void PointerInput::On(const MoveEvent& event, ViewerState& viewer) {
  const R2::Point now{event.x, event.y}, last = std::exchange(viewer.screen.pointer, now);
  if (viewer.layout().IsOnSection(last) || viewer.layout().IsOnSection(now)) viewer.notices.Redraw();
  if (!press_) FollowByCut(viewer);
  if (!press_ || press_->what == Drags::section) return;
  press_->is_click = press_->is_click && Distance(now, press_->at) <= click_reach;
  if (press_->is_click) return;
  switch (press_->what) {
    case Drags::flat:
      return DragFlat(viewer, last, now, false);
    case Drags::slider:
      return DragFlat(viewer, last, now, true);
    case Drags::crop:
      return Crop(viewer, press_->at, now);
    case Drags::chosen:
      if (const auto ray = viewer.RayAt(now)) viewer.editor.DragTo(*ray);
      return;
    case Drags::view:
      return viewer.navigator.DragTo(now);
    case Drags::section:
      break;
  }
}

void PointerInput::OnClick(const ButtonEvent& event, ViewerState& viewer) {
  const R2::Point position{event.x, event.y};
  if (event.button == Button::right) return DebugPixelAt(viewer, position);
  if (event.button != Button::left || event.modifiers != Modifiers{}) return;
  const double now = viewer.notices.Now();
  const bool is_second =
      last_click_ >= 0 && now - last_click_ <= double_click_time && Distance(position, last_click_at_) <= click_reach;
  last_click_ = is_second ? -1 : now;
  last_click_at_ = position;
  if (is_second && !viewer.FlatJob()) return SetPivot(viewer, viewer.PointAt(position));
  PickAt(viewer, viewer.InShownImage(position));
}

void PointerInput::On(const ScrollEvent& event, ViewerState& viewer) const {
  if (viewer.layout().IsOnSection({event.x, event.y}) && !press_) return MoveSection(viewer, event.steps < 0 ? -1 : 1);
  if (viewer.FlatJob()) return ZoomFlat(viewer, event);
  viewer.navigator.Scroll(event, PointFinder(viewer));
}

}  // namespace ray

#pragma once

#include <optional>

#include "source/draw/Event.h"
#include "source/view/ViewerState.h"

namespace ray {

/// The handler of the pointer: presses that become clicks or drags, of the view, the flat image, the cross section, or
/// the selection in the scene.
class PointerInput {
 public:
  void On(const ButtonEvent& event, ViewerState& viewer);
  void On(const MoveEvent& event, ViewerState& viewer);
  void On(const ScrollEvent& event, ViewerState& viewer) const;

  /// Returns true if releasing the button would end the current action.
  bool IsHeldBy(Button button) const { return press_ && press_->button == button; }
  /// The current press has had an effect, so it is no click.
  void TakeNoClick() {
    if (press_) press_->is_click = false;
  }

 private:
  enum class Drags { view, section, flat, slider, chosen, crop };
  struct Press {
    Button button;
    R2::Point at;
    Drags what;
    bool is_click = true;  // until it has gone too far
  };

  void Begin(const ButtonEvent& event, ViewerState& viewer);
  void OnClick(const ButtonEvent& event, ViewerState& viewer);

  std::optional<Press> press_;
  double last_click_ = -1;  // seconds of ticks
  R2::Point last_click_at_;
};

}  // namespace ray

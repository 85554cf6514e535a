#include "source/view/Viewer.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "source/view/KeyBindings.h"
#include "source/view/commands/Commands.h"
#include "source/view/show/Show.h"

namespace ray {
namespace {

constexpr double seconds_between_looks = 0.25;  // at the scene's files

}  // namespace

Viewer::Viewer(ViewerSettings settings, std::shared_ptr<const LoadedScene> scene, ViewerHost& host)
    : state_(std::move(settings), *scene, host) {
  TakeScene(state_, std::move(scene));
  if (state_.settings.shows_traced) state_.traced.ShowLive({});
}

namespace {

/// Returns null if the key is not bound.
const KeyBinding* FindBinding(const KeyEvent& event) {
  const auto found = std::ranges::find_if(KeyBindings(), [&](const KeyBinding& binding) {
    return binding.key == event.key && binding.modifiers == event.modifiers;
  });
  return found == KeyBindings().end() ? nullptr : &*found;
}

bool IsAction(const Event& event) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) return key->is_pressed;
  if (const auto* button = std::get_if<ButtonEvent>(&event)) return button->is_pressed;
  return std::holds_alternative<DropEvent>(event) || std::holds_alternative<CloseEvent>(event);
}

/// The event with its position, if it has one, counted from the lower left corner of the view.
template <typename Kind>
Kind InView(Kind event, double bottom) {
  if constexpr (requires { event.y; }) event.y -= bottom;
  return event;
}

}  // namespace

bool Viewer::Handle(const Event& event) {
  const bool is_action = IsAction(event);
  if (is_action) state_.notices.CountAction();
  const bool is_used = Deliver(event);
  if (is_action && !is_used) state_.notices.TakeBackAction();  // a recording is without it
  return is_used;
}

bool Viewer::Deliver(const Event& event) {
  if (state_.settings.shows_bar && std::holds_alternative<MoveEvent>(event)) state_.notices.Redraw();
  if (state_.shows.panels || state_.shows.help) {
    if (!std::holds_alternative<TickEvent>(event)) state_.notices.Redraw();
    const bool is_taken = state_.panels->Take(event, state_);
    const auto* button = std::get_if<ButtonEvent>(&event);
    const bool is_let_go = button && !button->is_pressed;
    if (is_let_go) state_.editor.DoHeld();
    // Whatever panels came up since the press: a drag that nobody ends would go on for ever.
    if (is_taken && !(is_let_go && pointer_.IsHeldBy(button->button))) return true;
  }
  // From here on positions are those in the view.
  const bool is_used = std::visit(
      [this]<typename Kind>(const Kind& e) {
        if constexpr (std::is_same_v<Kind, KeyEvent> || std::is_same_v<Kind, TextEvent>) return On(e);
        On(InView(e, state_.layout().bottom));
        return true;
      },
      event);
  state_.navigator.SetSize(state_.layout().view);
  return is_used;
}

bool Viewer::On(const KeyEvent& event) {
  if (state_.navigator.HoldKey(event)) {
    pointer_.TakeNoClick();
    return true;
  }
  if (!event.is_pressed) {
    bool is_bound = false;
    for (const KeyBinding& binding : KeyBindings()) {
      if (binding.key != event.key) continue;  // whatever other keys are held by now
      is_bound = true;
      if (binding.release) binding.release(state_);
    }
    return is_bound;
  }
  const KeyBinding* const binding = FindBinding(event);
  if (!binding) return false;
  const std::string before = state_.notices.TakeMessage();
  binding->act(state_);
  // Closing and screenshots save the drawing that the user saw last.
  if (state_.is_closed || state_.notices.Message().empty()) state_.notices.PutBack(before);
  state_.notices.Redraw();
  return true;
}

void Viewer::On(const ResizeEvent& event) {
  const DrawingSize size{std::max(1, event.width), std::max(1, event.height)};
  state_.screen.scale = event.scale;
  state_.panels->SetScale(event.scale);
  state_.section_pane.drawing.reset();
  if (size == state_.screen.size) return;
  state_.screen.size = size;
  state_.crop.reset();  // its pixels are others now
  state_.notices.RedrawLines();
}

void Viewer::On(const DropEvent& event) { OpenScene(state_, event.file); }

void Viewer::On(const CloseEvent&) { Quit(state_); }

void Viewer::On(const TickEvent& event) {
  // Not before time passes: a script that only draws gets the scene alone.
  if (!std::exchange(has_ticked_, true) && Message().empty()) ShowMessage("H: help" + state_.NotesAfterMessage());
  state_.notices.Advance(event.seconds);
  state_.navigator.Advance(event.seconds);
  const double now = state_.notices.Now();
  if (now - last_look_at_files_ < seconds_between_looks) return;
  last_look_at_files_ = now;
  if (state_.watch.HasChanged()) TakeChangedFiles(state_);
}

bool Viewer::Update() {
  state_.reader.Update();
  state_.editor.DoDue();
  if (state_.navigator.Changes() != changes_seen_) {
    changes_seen_ = state_.navigator.Changes();
    state_.traced.TouchView();
    state_.section_pane.drawing.reset();
    if (ShowsFrameOfQuad(state_) != lines_have_quad_frame_) state_.notices.RedrawLines();
    state_.notices.Redraw();
  }
  const DrawingSize view = state_.layout().view;  // panels and the cross section leave less of the drawing
  if (view != std::exchange(size_of_view_, view)) state_.traced.Touch();
  state_.traced.Update(state_.scene.Shared(), state_.SettingsOfView(), state_.settings.budget_of_rest);
  if (state_.scene.TakeFaces()) state_.notices.Redraw();
  TakeEndedJobs(state_);
  state_.status.Update(state_.traced, state_.notices.Now());
  if (std::string progress = state_.reader.Describe() + state_.status.Text(); progress != progress_) {
    progress_ = std::move(progress);
    state_.notices.Redraw();
  }
  const bool has_costs = state_.accelerators.HasNews(), has_rows = HasNewRows();
  const bool shows_traced = Traced().ShownLive() != nullptr, is_fading = shows_traced && Traced().Opacity() < 1;
  const bool is_switched = std::exchange(showed_traced_, shows_traced) != shows_traced;
  if (has_costs || has_rows || is_switched || std::exchange(was_fading_, is_fading)) state_.notices.Redraw();
  return state_.notices.TakeRedraw();
}

void Viewer::WaitForScene() {
  do {
    state_.reader.Update(true);
    state_.editor.DoDue();
  } while (state_.reader.IsBusy());
}

bool Viewer::HasNewRows() {
  std::vector<std::uint32_t> versions;
  for (const RenderJob* job : {Traced().Trace(), Traced().Live(), Traced().Depths()})
    for (int row = 0; job && row < job->frame().Height(); ++row) versions.push_back(job->frame().Version(row));
  if (versions == versions_) return false;
  versions_ = std::move(versions);
  return true;
}

FrameState Viewer::Show() {
  if (state_.notices.TakeNewLines()) {
    lines_ = std::make_shared<const Lines>(MakeLines(state_));
    lines_have_quad_frame_ = ShowsFrameOfQuad(state_);
  }
  return MakeFrame(state_, lines_);
}

std::string Viewer::Title() const { return TitleOf(state_); }

std::string Viewer::Describe() { return DescribeWithoutPanels() + TextOfPanels(); }

std::string Viewer::DescribeWithoutPanels() { return DescribeState(state_); }

std::string Viewer::TextOfPanels() { return ray::TextOfPanels(state_); }

const std::vector<PanelItem>& Viewer::ItemsOfPanels() const {
  static const std::vector<PanelItem> none;
  return state_.shows.panels || state_.shows.help ? state_.panels->Items() : none;
}

void Viewer::Reveal(const std::string& name) {
  if (state_.shows.panels || state_.shows.help) state_.panels->Reveal(state_, name);
}

void Viewer::ShowPanels(const PanelSettings& look) { ray::ShowPanels(state_, look); }

void Viewer::ShowMistakes(const SceneErrors& mistakes) { ShowProblems(state_, state_.settings.scene, mistakes); }

}  // namespace ray

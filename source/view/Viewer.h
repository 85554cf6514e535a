#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "source/draw/Event.h"
#include "source/draw/FrameState.h"
#include "source/view/PointerInput.h"
#include "source/view/ViewerState.h"

namespace ray {

/// A scene being looked at: it handles the user's events and says what to draw. Knows nothing of windows and
/// OpenGL; for one thread.
///
/// An event goes to the panels first, where they are shown; then to the pointer (PointerInput.h), or to the table of
/// keys (KeyBindings.h), whose commands (commands/) change the state. Frames are made of that (show/).
class Viewer {
 public:
  /// `scene`: read from the settings' file. The host must outlive it.
  Viewer(ViewerSettings settings, std::shared_ptr<const LoadedScene> scene, ViewerHost& host);

  /// Returns false if the event is a key that is not bound, or text outside of a field, and so does nothing.
  bool Handle(const Event& event);
  /// Starts and ends jobs that are due. Returns true if the result of Show has changed.
  bool Update();
  /// Valid until the next call of Handle or Update.
  FrameState Show();
  /// Returns true if a job is running, so that Update is soon worth a call.
  bool IsBusy() const {
    return state_.traced.IsBusy() || state_.accelerators.IsBusy() || state_.scene.IsMakingFaces() ||
           state_.reader.IsBusy();
  }
  bool IsClosed() const { return state_.is_closed; }

  /// The title as of the last Update. Time alone changes it, a few times a second; see TitleOf.
  std::string Title() const;
  /// Describes the drawing in lines, for scripts.
  std::string Describe();
  /// Returns the same description without the text of the panels, which would change how far they are scrolled.
  std::string DescribeWithoutPanels();
  /// Returns the text of the panels and the help, in lines; empty if they are hidden.
  std::string TextOfPanels();
  /// Scrolls the item of the panels whose name begins with this into view.
  void Reveal(const std::string& name);
  /// Returns the items of the panels that take clicks, as last drawn.
  const std::vector<PanelItem>& ItemsOfPanels() const;

  // For the program around it.
  void ShowPanels(const PanelSettings& look);
  /// Shows the mistakes in the file of the settings, for which another scene is shown.
  void ShowMistakes(const SceneErrors& mistakes);
  /// Waits for the scene that is being read, so that the next event finds it shown.
  void WaitForScene();
  bool IsReading() const { return state_.reader.IsBusy(); }
  /// Waits for the preview of the scene, so that Show has it.
  void WaitForFaces() { state_.scene.TakeFaces(true); }
  /// Shows a message.
  void ShowMessage(const std::string& message) { state_.notices.Show(message); }

  ViewerState& state() { return state_; }
  const ViewerState& state() const { return state_; }
  const LoadedScene& scene() const { return state_.scene.Loaded(); }
  const Navigator& navigator() const { return state_.navigator; }
  const TracedImages& Traced() const { return state_.traced; }
  const RayInspector& Rays() const { return state_.rays; }
  const std::optional<Pick>& Picked() const { return state_.selection.pick; }
  const std::string& Message() const { return state_.notices.Message(); }
  DrawingSize Size() const { return state_.screen.size; }

 private:
  /// Passes the event to the panels or the view. Returns false if it has no effect.
  bool Deliver(const Event& event);
  bool On(const KeyEvent& event);
  static bool On(const TextEvent&) { return false; }
  void On(const ButtonEvent& event) { pointer_.On(event, state_); }
  void On(const MoveEvent& event) { pointer_.On(event, state_); }
  void On(const ScrollEvent& event) { pointer_.On(event, state_); }
  void On(const ResizeEvent& event);
  void On(const DropEvent& event);
  void On(const TickEvent& event);
  void On(const CloseEvent&);
  /// Returns true if rows of frames were written since the last call.
  bool HasNewRows();

  ViewerState state_;
  PointerInput pointer_;
  bool has_ticked_ = false, showed_traced_ = false, was_fading_ = false;
  DrawingSize size_of_view_;       // when last updated
  double last_look_at_files_ = 0;  // seconds of ticks
  std::uint64_t changes_seen_ = 0;
  std::string progress_;  // of reading and rendering, as last shown
  std::shared_ptr<const Lines> lines_;
  bool lines_have_quad_frame_ = false;
  std::vector<std::uint32_t> versions_;  // of the rows of frames when last seen
};

}  // namespace ray

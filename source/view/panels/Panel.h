#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "R2/Color.h"
#include "R3/Point.h"
#include "source/view/ViewerState.h"
#include "source/view/panels/Panels.h"

namespace ray {

/// The context in which a panel is drawn: its data and its actions. The widgets below are those of Dear ImGui, known to
/// scripts besides.
class PanelFrame {
 public:
  /// `sought`: the beginning of the name of what is to be scrolled into view; empty for nothing.
  PanelFrame(const ViewerState& shown, double pixels_per_unit, std::vector<PanelItem>& items, std::string sought)
      : viewer(shown), scale(pixels_per_unit), items_(items), sought_(std::move(sought)) {}

  const ViewerState& viewer;
  const double scale;

  /// Adds an action for when the frame is complete: panels never change what they are drawing.
  void Ask(std::function<void(ViewerState&)> action) { actions_.push_back(std::move(action)); }
  const std::vector<std::function<void(ViewerState&)>>& Asked() const { return actions_; }

  /// Returns true if it was clicked.
  bool Button(const std::string& name);
  /// A line that can be chosen, cut short where it has no room; whether it was clicked.
  bool Choice(const std::string& name, bool is_chosen);
  /// One of several words; whether it was clicked, and was not the one already.
  bool Word(const char* name, bool is_it);
  /// A switch; whether it was clicked.
  bool Check(const std::string& name, bool is_on);
  /// A heading that opens and closes what is below it; whether that is open.
  bool Heading(const char* name, bool is_open_at_first);
  /// Writes text, which continues in the next line where the panel ends.
  void Say(const std::string& text);
  /// Writes a name and its value.
  void Fact(const std::string& name, const std::string& value);
  /// Registers the last widget for scripts.
  void Note(const std::string& name);

 private:
  std::vector<PanelItem>& items_;
  std::string sought_;
  std::vector<std::function<void(ViewerState&)>> actions_;
};

/// The text, or as much of its beginning as has room, in pixels; scripts get all of it. Letters are of one width.
std::string Fitting(const std::string& text, float room);

/// One part of a panel; it may remember what is open in it.
class Panel {
 public:
  virtual ~Panel() = default;
  virtual void Draw(PanelFrame& frame) = 0;
  /// Returns true if it has anything to show.
  virtual bool IsOfUse(const ViewerState&) const { return true; }
};

/// A part as the table of panels in Panels.cpp names it.
struct PanelPart {
  const char* caption;  // shown where a panel has several
  std::unique_ptr<Panel> (*make)();
};

// Numbers as panels show them: rounded, so that they fit side by side.

std::string Brief(double number);
std::string Brief(const R2::Color& color);
std::string Brief(const R3::Point& point);
std::string Brief(const R3::Vector& vector);
/// Words with their numbers rounded, where those stand between blanks or before commas.
std::string Brief(const std::string& words);

/// The scene, how far its image has come and how right it is, and the pixel under the pointer: in the window of Dear
/// ImGui that is being made, a line of its width.
void DrawStatusBar(PanelFrame& frame);

}  // namespace ray

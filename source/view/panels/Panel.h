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
  /// `sought`: the beginning of the name of the item to scroll into view; empty for none.
  PanelFrame(const ViewerState& shown, double pixels_per_unit, std::vector<PanelItem>& items, std::string sought)
      : viewer(shown), scale(pixels_per_unit), items_(items), sought_(std::move(sought)) {}

  const ViewerState& viewer;
  const double scale;

  /// Adds an action for the end of the frame: panels never change the data that they draw.
  void Ask(std::function<void(ViewerState&)> action) { actions_.push_back(std::move(action)); }
  const std::vector<std::function<void(ViewerState&)>>& Asked() const { return actions_; }

  /// Returns true if it was clicked.
  bool Button(const std::string& name);
  /// A line that can be chosen, shortened to fit; returns true if it was clicked.
  bool Choice(const std::string& name, bool is_chosen);
  /// One of several words; returns true if it was clicked and is not the current one.
  bool Word(const char* name, bool is_it);
  /// A switch; returns true if it was clicked.
  bool Check(const std::string& name, bool is_on);
  /// A heading that opens and closes the part below it; returns true if that is open.
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

/// The text, or the beginning that fits into the room, in pixels; scripts get all of it. Letters have equal widths.
std::string Fitting(const std::string& text, float room);

/// One part of a panel; it may remember which of its headings are open.
class Panel {
 public:
  virtual ~Panel() = default;
  virtual void Draw(PanelFrame& frame) = 0;
  /// Returns true if it has anything to show.
  virtual bool IsOfUse(const ViewerState&) const { return true; }
};

/// A part, as listed in the table of panels in Panels.cpp.
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

/// The scene, the progress and error of its image, and the pixel under the pointer: in the window of Dear
/// ImGui that is being made, a line of its width.
void DrawStatusBar(PanelFrame& frame);

}  // namespace ray

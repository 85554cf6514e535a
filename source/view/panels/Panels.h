#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/draw/Event.h"
#include "source/draw/PanelDrawing.h"

namespace ray {

struct ViewerState;

/// Something in a panel that takes clicks.
struct PanelItem {
  std::string name;
  double x = 0, y = 0;  // its middle, in pixels from the lower left corner of the drawing
};

/// The parts of the panels that are shown.
struct PanelParts {
  bool column = false;
  bool help = false;
  bool bar = false;  // the status bar: below the view if there is a column, else over its lower edge
};

enum class PanelTheme { dark, light };
inline constexpr double smallest_letters = 0.75, largest_letters = 3;  // times the usual size

/// The preferences of a user.
struct PanelSettings {
  PanelTheme theme = PanelTheme::dark;
  double letters = 1;  // their size, in the range above
  double width = 0;    // of the column, in units of length at that size; 0: as usual
  friend bool operator==(const PanelSettings&, const PanelSettings&) = default;
};

/// All text of the viewer: labels; if they are shown, a column next to the image with facts and choices about the
/// scene and its rays, and a status bar above it; and the help. What they show depends on the events and on
/// the viewer alone, never on how often they are drawn.
class Panels {
 public:
  virtual ~Panels() = default;
  /// Returns true if they keep the event from the viewer: of the pointer if it is over them; of keys while text is
  /// being entered. The viewer's requests are carried out before this returns.
  virtual bool Take(const Event& event, ViewerState& viewer) = 0;
  /// Sets the parts that are shown. If there are fewer, keys and buttons are released, and text entry ends.
  virtual void SetParts(const PanelParts& parts) = 0;
  /// The width of the column, in pixels, when it is next drawn in a drawing of width `all`.
  virtual double Width(double all) const = 0;
  /// The height of the status bar, in pixels.
  virtual double HeightOfBar() const = 0;
  /// The size of letters of labels.
  virtual LetterSize Letters() = 0;
  /// Draws the panels as they are now, with these labels below them.
  virtual std::shared_ptr<const PanelDrawing> Draw(ViewerState& viewer, const std::vector<Label>& labels) = 0;
  /// Returns their text, in lines, even if scrolled out of sight; for scripts.
  virtual std::string Text(ViewerState& viewer) = 0;
  /// Scrolls the first item whose name begins with this into view. Returns false if there is none.
  virtual bool Reveal(ViewerState& viewer, const std::string& name) = 0;
  /// Returns the items that take clicks, as last drawn.
  virtual const std::vector<PanelItem>& Items() const = 0;
  virtual void SetLook(const PanelSettings& look) = 0;
  virtual const PanelSettings& Look() const = 0;
  /// Pixels per unit of length, > 0: 1 on usual screens, 2 on dense ones.
  virtual void SetScale(double scale) = 0;
};

std::unique_ptr<Panels> MakePanels();

}  // namespace ray

#pragma once

#include <string>
#include <variant>
#include <vector>

#include "source/draw/Event.h"
#include "source/parse/Text.h"

/// The events of a viewer as text, written by people or recorded. One step per line; # starts a comment,
/// except in the rest of a line that is text or a name. A step that does nothing is an error: a key without a function,
/// text outside of a field, a click in the panels without effect, a click outside of the drawing, a wait for no image.
///
///     key Control+S              pressed and released
///     press W / release W
///     type hello                 what keys have typed, into a field for text; the rest of the line
///     origin bottom              from here on, y counts from the bottom of the drawing; otherwise from its top
///     down left 100 200 Shift    a button, at a position x y in pixels, with modifiers held
///     up left 100 200
///     move 120 210               the pointer
///     click right 75 50          down and up
///     drag left 10 10 90 40      down, eight moves, up
///     scroll -1 100 100          towards the user
///     resize 640 480             and 2 behind it for a screen twice as dense
///     drop other.scn             the rest of the line is the name of a file
///     tick 0.1                   that many seconds pass
///     close
///     wait trace                 until all that is being rendered has ended
///     wait image                 until the traced image is whole; it is shown from then on
///     wait rows 100              until that many rows are rendered
///     wait 0.5                   seconds
///     screenshot out.png
///     panel Settings             a click in the panels, on the first item whose name begins with this
///     print                      a description of the drawing
namespace ray {

/// Sets the edge from which y counts in later steps.
struct Origin {
  bool is_bottom = false;
};
struct WaitForTrace {};
struct WaitForImage {};
struct WaitForRows {
  int rows = 0;
};
struct WaitSeconds {
  double seconds = 0;
};
struct Screenshot {
  std::string file;
};
struct ClickPanel {
  std::string name;
};
struct PrintState {};

struct ScriptStep {
  std::variant<Event, Origin, WaitForTrace, WaitForImage, WaitForRows, WaitSeconds, Screenshot, ClickPanel, PrintState>
      what;
  Token word{};  // the first of its line
};

/// Reads a script, which must outlive its steps. Throws SceneErrors that point at each mistake.
std::vector<ScriptStep> ReadEventScript(const Text& text);

/// Returns an event as lines of a script, each with its end; empty for the size of a minimized window, which is 0.
std::string ScriptLine(const Event& event);

}  // namespace ray

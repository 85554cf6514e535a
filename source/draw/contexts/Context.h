#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "source/draw/Event.h"

namespace ray {

/// The reason why there is no OpenGL context, in one line, with a remedy.
struct ContextError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A context of OpenGL 3.3 core: current on the thread that made it, until it is destroyed there.
class Context {
 public:
  virtual ~Context() = default;
  /// Returns the kind and the renderer: "egl: llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
  virtual std::string Name() const = 0;
};

/// A context on a screen, which draws into framebuffer 0.
class Window : public Context {
 public:
  virtual int Width() const = 0;  // of the framebuffer, in pixels
  virtual int Height() const = 0;
  virtual double Scale() const = 0;  // of its screen, as in ResizeEvent
  virtual void Show() = 0;           // shows the drawing
  virtual void SetTitle(const std::string& title) = 0;
  virtual void SetClipboard(const std::string& text) = 0;
  /// Returns the events since the last call, in order; waits for at most `seconds` while there are none. May return an
  /// empty list early, for instance because of WakeWindow. A held key is reported once, or repeatedly if it steps
  /// (arrows, signs). A required redraw is reported as a ResizeEvent, even if the size is unchanged.
  virtual std::vector<Event> Wait(double seconds) = 0;
};

/// Ends the window's Wait early. Can be called from any thread while the window exists.
void WakeWindow();

/// Returns the available kinds: "egl", "osmesa"; may be empty.
std::vector<std::string> OffscreenContextKinds();
/// Creates a context without a display, which draws into its own framebuffers. `kind`: one of those, or "auto" for the
/// first that works. Throws ContextError.
std::unique_ptr<Context> MakeOffscreenContext(const std::string& kind);

/// Returns true if windows are available in this build.
bool HasWindows();
/// Creates a window: one at a time, on the main thread. Throws ContextError, which says so if there is no display.
std::unique_ptr<Window> MakeWindow(int width, int height, const std::string& title);

}  // namespace ray

#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "source/draw/Event.h"

namespace ray {

/// Why there is nothing to draw with; one line, with what would help.
struct ContextError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Somewhere to draw with OpenGL 3.3 core: current on the thread that made it, until it is destroyed there.
class Context {
 public:
  virtual ~Context() = default;
  /// "egl: llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5": the kind and the renderer.
  virtual std::string Name() const = 0;
};

/// A context on a screen, which draws into framebuffer 0.
class Window : public Context {
 public:
  virtual int Width() const = 0;  // of the framebuffer, in pixels
  virtual int Height() const = 0;
  virtual double Scale() const = 0;  // of its screen, as of a ResizeEvent
  virtual void Show() = 0;           // what was drawn
  virtual void SetTitle(const std::string& title) = 0;
  virtual void SetClipboard(const std::string& text) = 0;
  /// What has happened since the last call, in order; waits for at most `seconds` while there is nothing. May return
  /// early with nothing, as WakeWindow makes it. A key held is reported once, one that steps (arrows, signs) again
  /// and again; what has to be redrawn is reported as a ResizeEvent, of whatever size.
  virtual std::vector<Event> Wait(double seconds) = 0;
};

/// Ends the Wait of the window early; from any thread, while there is the window.
void WakeWindow();

/// The kinds built in: "egl", "osmesa"; may be empty.
std::vector<std::string> OffscreenContextKinds();
/// A context that needs no display and draws into framebuffers of its own making. `kind`: one of those, or "auto" for
/// the first that works. Throws ContextError.
std::unique_ptr<Context> MakeOffscreenContext(const std::string& kind);

/// Whether windows are built in.
bool HasWindows();
/// One at a time, on the main thread. Throws ContextError, which says so when there is no display.
std::unique_ptr<Window> MakeWindow(int width, int height, const std::string& title);

}  // namespace ray

#include <epoxy/gl.h>

#include <array>

#include "source/draw/contexts/Context.h"
#include "source/draw/contexts/ContextKind.h"

namespace ray {
namespace {

/// A kind that may be missing in this build.
struct KnownKind {
  const char* name;
  const char* package;  // that provides it
  const ContextKind* kind;
};

#ifdef RAYVIEW_EGL
constexpr const ContextKind* egl = &egl_context;
#else
constexpr const ContextKind* egl = nullptr;
#endif
#ifdef RAYVIEW_OSMESA
constexpr const ContextKind* osmesa = &osmesa_context;
#else
constexpr const ContextKind* osmesa = nullptr;
#endif

// The kinds in the order in which they are tried: EGL uses a GPU if there is one.
constexpr std::array known_kinds{KnownKind{"egl", "libepoxy-dev", egl}, KnownKind{"osmesa", "libosmesa6-dev", osmesa}};

std::unique_ptr<Context> MakeFirst() {
  std::string why, packages;
  for (const KnownKind& known : known_kinds) {
    packages += std::string(packages.empty() ? "" : " or ") + known.package;
    if (!known.kind) continue;
    try {
      return known.kind->make();
    } catch (const ContextError& error) {
      why += std::string(why.empty() ? "" : "; ") + known.name + ": " + error.what();
    }
  }
  if (why.empty()) throw ContextError("drawing without a window is not built in; install " + packages + " and rebuild");
  throw ContextError("cannot draw without a window: " + why);
}

}  // namespace

std::vector<std::string> OffscreenContextKinds() {
  std::vector<std::string> kinds;
  for (const KnownKind& known : known_kinds)
    if (known.kind) kinds.push_back(known.name);
  return kinds;
}

std::unique_ptr<Context> MakeOffscreenContext(const std::string& kind) {
  if (kind == "auto") return MakeFirst();
  std::string names = "auto";
  for (const KnownKind& known : known_kinds) {
    names += std::string(", ") + known.name;
    if (kind != known.name) continue;
    if (!known.kind) throw ContextError(kind + " is not built in; install " + known.package + " and rebuild");
    try {
      return known.kind->make();
    } catch (const ContextError& error) {
      throw ContextError(kind + ": " + error.what());
    }
  }
  throw ContextError("unknown context '" + kind + "'; choose one of " + names);
}

#ifndef RAYVIEW_GLFW
void WakeWindow() {}

bool HasWindows() { return false; }

std::unique_ptr<Window> MakeWindow(int, int, const std::string&) {
  throw ContextError("windows are not built in; install libglfw3-dev and rebuild, or use rayview -headless");
}
#endif

std::string CurrentRenderer() {
  const auto text = [](GLenum what) {
    const GLubyte* string = glGetString(what);
    return std::string(string ? reinterpret_cast<const char*>(string) : "unknown");
  };
  // The version is followed by the vendor's own.
  const std::string version = text(GL_VERSION);
  return text(GL_RENDERER) + ", OpenGL " + version.substr(0, version.find(' '));
}

}  // namespace ray

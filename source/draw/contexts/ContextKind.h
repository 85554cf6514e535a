#pragma once

#include <memory>
#include <string>

#include "source/draw/contexts/Context.h"

namespace ray {

/// A kind of contexts without a window; one per file.
struct ContextKind {
  const char* name;                    // "egl"
  std::unique_ptr<Context> (*make)();  // current on this thread; throws ContextError, one line without the kind's name
};

#ifdef RAYVIEW_EGL
extern const ContextKind egl_context;
#endif
#ifdef RAYVIEW_OSMESA
extern const ContextKind osmesa_context;
#endif

/// Returns the renderer of the current context: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
std::string CurrentRenderer();

}  // namespace ray

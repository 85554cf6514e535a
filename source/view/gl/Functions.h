#pragma once

// The prototypes serve for their types alone; nothing is linked with OpenGL.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>

#include "source/view/contexts/Context.h"

namespace ray {

/// The functions of OpenGL 3.3 core that we call, found through the context: which library they come from is known only
/// when the program runs, and each kind of context has its own.
struct Functions {
  /// The context must be current. Throws ContextError that names the function there is not, or the version of OpenGL
  /// when it is before 3.3.
  explicit Functions(const Context& context);

#define FUNCTION(name) decltype(&::gl##name) name = nullptr;
#include "source/view/gl/functions.def"
#undef FUNCTION
};

}  // namespace ray

#include <epoxy/gl.h>

#include "source/draw/contexts/ContextKind.h"

namespace ray {

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

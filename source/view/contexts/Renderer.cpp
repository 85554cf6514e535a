#include <GL/glcorearb.h>

#include "source/view/contexts/ContextKind.h"

namespace ray {

std::string RendererOf(Context::Function (*find)(const char* name)) {
  const auto text = reinterpret_cast<PFNGLGETSTRINGPROC>(find("glGetString"));
  if (!text) return "an unknown renderer";
  const auto of = [text](GLenum what) {
    const GLubyte* string = text(what);
    return std::string(string ? reinterpret_cast<const char*>(string) : "unknown");
  };
  // The version is followed by whose it is.
  const std::string version = of(GL_VERSION);
  return of(GL_RENDERER) + ", OpenGL " + version.substr(0, version.find(' '));
}

}  // namespace ray

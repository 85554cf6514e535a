#include "source/view/gl/Functions.h"

namespace ray {

namespace {

template <typename Type>
void Find(const Context& context, const char* name, Type& function) {
  function = reinterpret_cast<Type>(context.Find(name));
  if (!function) throw ContextError(context.Name() + " lacks the function " + name + "; OpenGL 3.3 is needed");
}

}  // namespace

Functions::Functions(const Context& context) {
#define FUNCTION(name) Find(context, "gl" #name, this->name);
#include "source/view/gl/functions.def"
#undef FUNCTION
  // Libraries that pass calls on have every function, whatever is behind them.
  GLint major = 0, minor = 0;
  GetIntegerv(GL_MAJOR_VERSION, &major);
  GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor >= 33) return;
  throw ContextError(context.Name() + " has OpenGL " + std::to_string(major) + "." + std::to_string(minor) +
                     "; 3.3 is needed");
}

}  // namespace ray

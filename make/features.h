// Which packages this machine has: the preprocessor leaves the names of those whose headers it finds, and only a
// compiler knows where it looks for them. The first says that it ran.
compiler
#if __has_include(<jpeglib.h>)
jpeg
#endif
#if __has_include(<png.h>)
png
#endif
#if __has_include(<tbb/parallel_for.h>)
tbb
#endif
#if __has_include(<hwy/highway.h>)
hwy
#endif
#if __has_include(<nlohmann/json.hpp>)
json
#endif
#if __has_include(<ImfOutputFile.h>)
exr
#endif
#if __has_include(<yaml-cpp/parser.h>)
yaml
#endif
// libepoxy finds OpenGL; one of the three below it makes what is drawn into.
#if __has_include(<epoxy/gl.h>)
epoxy
#endif
#if __has_include(<GLFW/glfw3.h>)
glfw
#endif
#if __has_include(<epoxy/egl.h>) && __has_include(<EGL/egl.h>)
egl
#endif
#if __has_include(<GL/osmesa.h>)
osmesa
#endif
#if __has_include(<imgui.h>)
imgui
#endif

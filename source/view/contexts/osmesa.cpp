#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>

#include "source/view/contexts/ContextKind.h"

// Without a window through OSMesa, Mesa's drawing into memory; it ends with Mesa 25.0.
//   source   Mesa, include/GL/osmesa.h
namespace ray {

namespace {

/// The library, loaded when it is first asked for: linked with, it and the compiler inside it would be loaded at every
/// start. It stays: the compiler's threads may still run in it.
void* Library() {
  static void* const library = [] {
    void* newest = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    return newest ? newest : dlopen("libOSMesa.so", RTLD_NOW | RTLD_LOCAL);
  }();
  return library;
}

template <typename Type>
Type FindInLibrary(const char* name) {
  const auto function = reinterpret_cast<Type>(dlsym(Library(), name));
  if (!function) throw ContextError(std::string("libOSMesa lacks ") + name);
  return function;
}

Context::Function FindInGl(const char* name) {
  return FindInLibrary<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress")(name);
}

class OsMesaContext : public Context {
 public:
  OsMesaContext() {
    if (!Library()) throw ContextError("libOSMesa.so.8 cannot be loaded; libosmesa6 brings it");
    constexpr std::array<int, 11> wanted{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         24,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         0};
    const auto make_current = FindInLibrary<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    destroy_ = FindInLibrary<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
    context_ =
        FindInLibrary<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs")(wanted.data(), nullptr);
    if (!context_) throw ContextError("the library has no OpenGL 3.3 core");
    if (!make_current(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
      destroy_(context_);
      throw ContextError("the context cannot be used on this thread");
    }
    name_ = "osmesa: " + RendererOf(FindInGl);
  }

  // Takes it from the thread as well.
  ~OsMesaContext() override { destroy_(context_); }

  std::string Name() const override { return name_; }
  Function Find(const char* name) const override { return FindInGl(name); }

 private:
  std::array<unsigned char, 4> pixel_{};  // a context wants something to draw into, though we never do
  decltype(&OSMesaDestroyContext) destroy_ = nullptr;
  OSMesaContext context_ = nullptr;
  std::string name_;
};

std::unique_ptr<Context> Make() { return std::make_unique<OsMesaContext>(); }

}  // namespace

const ContextKind osmesa_context{"osmesa", Make};

}  // namespace ray

#include <epoxy/egl.h>

#include <array>
#include <sstream>
#include <vector>

#include "source/draw/contexts/ContextKind.h"

// Contexts without a window through EGL: on a GPU if there is one, otherwise in Mesa's software renderer, which needs
// no display.
//   source   Khronos, EGL 1.5; EGL_EXT_device_enumeration, EGL_EXT_platform_device, EGL_MESA_platform_surfaceless,
//            EGL_KHR_surfaceless_context, EGL_KHR_no_config_context
namespace ray {
namespace {

std::string LastError() {
  std::ostringstream text;
  text << "error 0x" << std::hex << eglGetError();
  return text.str();
}

struct Devices {
  std::vector<EGLDeviceEXT> gpus, software;
};

Devices AllDevices() {
  Devices devices;
  EGLint count = 0;
  if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return devices;
  std::vector<EGLDeviceEXT> all(static_cast<std::size_t>(count));
  if (!eglQueryDevicesEXT(count, all.data(), &count)) return devices;
  all.resize(static_cast<std::size_t>(count));
  for (EGLDeviceEXT device : all) {
    const bool is_software =
        epoxy_extension_in_string(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    (is_software ? devices.software : devices.gpus).push_back(device);
  }
  return devices;
}

/// Returns the displays on which a context may be made, the best first. Does not open them.
std::vector<EGLDisplay> Displays() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto has = [extensions](const char* name) { return epoxy_extension_in_string(extensions, name); };
  if (!has("EGL_EXT_platform_base")) return {};
  const Devices devices = has("EGL_EXT_platform_device") && has("EGL_EXT_device_base") ? AllDevices() : Devices{};
  std::vector<EGLDisplay> displays;
  const auto add = [&](EGLenum platform, void* what) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(platform, what, nullptr);
    if (display != EGL_NO_DISPLAY) displays.push_back(display);
  };
  for (EGLDeviceEXT device : devices.gpus) add(EGL_PLATFORM_DEVICE_EXT, device);
  if (has("EGL_MESA_platform_surfaceless")) add(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  for (EGLDeviceEXT device : devices.software) add(EGL_PLATFORM_DEVICE_EXT, device);
  return displays;
}

/// Returns a configuration for the context. Since we draw into our own framebuffers, any that supports OpenGL works,
/// and they are equally good.
EGLConfig Config(EGLDisplay display) {
  if (epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
  constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                         EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count < 1)
    throw ContextError("the driver has no configuration for OpenGL, " + LastError());
  return config;
}

class EglContext : public Context {
 public:
  /// Throws ContextError if the display has no OpenGL 3.3.
  explicit EglContext(EGLDisplay display) : display_(display) {
    if (!eglInitialize(display, nullptr, nullptr)) throw ContextError("a device cannot be opened, " + LastError());
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context"))
      throw ContextError("the driver lacks EGL_KHR_surfaceless_context");
    if (!eglBindAPI(EGL_OPENGL_API)) throw ContextError("the driver has no OpenGL, " + LastError());
    constexpr std::array<EGLint, 7> wanted{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display, Config(display), EGL_NO_CONTEXT, wanted.data());
    if (context_ == EGL_NO_CONTEXT) throw ContextError("the driver has no OpenGL 3.3 core, " + LastError());
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      const std::string why = LastError();
      eglDestroyContext(display, context_);
      throw ContextError("the context cannot be used on this thread, " + why);
    }
    name_ = "egl: " + CurrentRenderer();
  }

  // The display stays open: the library has one for the whole process, and other contexts may use it.
  ~EglContext() override {
    if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }

  std::string Name() const override { return name_; }

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string name_;
};

std::unique_ptr<Context> Make() {
  if (!epoxy_has_egl()) throw ContextError("cannot load libEGL; install libegl1");
  std::string why;
  for (EGLDisplay display : Displays()) try {
      return std::make_unique<EglContext>(display);
    } catch (const ContextError& error) {
      if (why.find(error.what()) == std::string::npos) why += std::string(why.empty() ? "" : ", ") + error.what();
    }
  throw ContextError(why.empty() ? "no driver found; install libegl-mesa0 and libgl1-mesa-dri" : why);
}

}  // namespace

const ContextKind egl_context{"egl", Make};

}  // namespace ray

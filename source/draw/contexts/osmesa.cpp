#include <dlfcn.h>
#include <epoxy/gl.h>

// After libepoxy, which must be the first to declare OpenGL.
#include <GL/osmesa.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>

#include "source/draw/contexts/ContextKind.h"

// Contexts without a window through OSMesa, Mesa's rendering into memory, which ends with Mesa 25.0.
//   source   Mesa, include/GL/osmesa.h
namespace ray {
namespace {

/// Loads the library at its first use: if it were linked, it and its compiler would be loaded at every start. It is
/// never unloaded, since the compiler's threads may still run in it.
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

/// The functions of OpenGL that we call, in OSMesa. libepoxy finds functions through GLX and EGL, which do not know
/// OSMesa, so its function pointers are replaced while this exists.
class Functions {
 public:
  // clang-format off
  Functions() {
#define USE(name) Use(epoxy_gl##name, "gl" #name);
    USE(ActiveTexture) USE(AttachShader) USE(BindBuffer) USE(BindBufferBase) USE(BindFramebuffer)
    USE(BindRenderbuffer) USE(BindSampler) USE(BindTexture) USE(BindVertexArray) USE(BlendFuncSeparate) USE(BlitFramebuffer) USE(BufferData)
    USE(BufferSubData) USE(CheckFramebufferStatus) USE(Clear) USE(ClearColor) USE(ColorMask) USE(CompileShader)
    USE(CreateProgram) USE(CreateShader) USE(CullFace) USE(DeleteBuffers) USE(DeleteFramebuffers)
    USE(DeleteProgram) USE(DeleteRenderbuffers) USE(DeleteSamplers) USE(DeleteShader) USE(DeleteTextures) USE(DeleteVertexArrays)
    USE(DepthFunc) USE(DepthMask) USE(Disable) USE(DrawArrays) USE(DrawBuffer) USE(DrawElements) USE(Enable)
    USE(EnableVertexAttribArray) USE(Finish) USE(FramebufferRenderbuffer) USE(FramebufferTexture2D)
    USE(FramebufferTextureLayer) USE(GenBuffers) USE(GenFramebuffers) USE(GenRenderbuffers) USE(GenSamplers)
    USE(GenTextures) USE(GenVertexArrays) USE(GenerateMipmap)
    USE(GetError) USE(GetFloatv) USE(GetFramebufferAttachmentParameteriv) USE(GetIntegerv)
    USE(GetProgramInfoLog) USE(GetProgramiv) USE(GetShaderInfoLog) USE(GetShaderiv) USE(GetString)
    USE(GetTexImage) USE(GetUniformBlockIndex) USE(GetUniformLocation) USE(LineWidth) USE(LinkProgram)
    USE(PixelStorei) USE(PolygonMode) USE(PolygonOffset) USE(ReadPixels) USE(RenderbufferStorage)
    USE(RenderbufferStorageMultisample) USE(SamplerParameteri) USE(Scissor)
    USE(ShaderSource) USE(TexImage2D) USE(TexImage3D) USE(TexParameteri) USE(TexSubImage2D) USE(Uniform1f)
    USE(Uniform1i) USE(Uniform2f) USE(Uniform2fv) USE(Uniform3fv) USE(Uniform4f) USE(UniformBlockBinding)
    USE(UniformMatrix4fv) USE(UseProgram) USE(VertexAttribPointer) USE(Viewport)
#undef USE
  }
  // clang-format on
  ~Functions() {
    for (const auto& restore : restore_) restore();
  }
  Functions(const Functions&) = delete;
  Functions& operator=(const Functions&) = delete;

 private:
  template <typename Type>
  void Use(Type& pointer, const char* name) {
    restore_.push_back([&pointer, before = pointer] { pointer = before; });
    pointer = reinterpret_cast<Type>(find_(name));
  }

  decltype(&OSMesaGetProcAddress) find_ = FindInLibrary<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
  std::vector<std::function<void()>> restore_;
};

class OsMesaContext : public Context {
 public:
  OsMesaContext() {
    if (!Library()) throw ContextError("cannot load libOSMesa.so.8; install libosmesa6");
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
    const auto create = FindInLibrary<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    const auto destroy = FindInLibrary<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
    context_ = {create(wanted.data(), nullptr), destroy};
    if (!context_) throw ContextError("the library has no OpenGL 3.3 core");
    if (!make_current(context_.get(), pixel_.data(), GL_UNSIGNED_BYTE, 1, 1))
      throw ContextError("the context cannot be used on this thread");
    functions_.emplace();
    name_ = "osmesa: " + CurrentRenderer();
  }

  std::string Name() const override { return name_; }

 private:
  // a context requires a buffer, though we never draw into it
  std::array<unsigned char, 4> pixel_{};
  using Handle = std::unique_ptr<std::remove_pointer_t<OSMesaContext>, decltype(&OSMesaDestroyContext)>;
  Handle context_{nullptr, nullptr};  // destruction also makes it no longer current
  std::optional<Functions> functions_;
  std::string name_;
};

std::unique_ptr<Context> Make() { return std::make_unique<OsMesaContext>(); }

}  // namespace

const ContextKind osmesa_context{"osmesa", Make};

}  // namespace ray

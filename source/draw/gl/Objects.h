#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace ray {

/// An object of OpenGL, deleted with its owner; the context has to be current then.
template <PFNGLGENBUFFERSPROC& generate, PFNGLDELETEBUFFERSPROC& remove>
class Object {
 public:
  Object() { generate(1, &name_); }
  ~Object() {
    if (name_) remove(1, &name_);
  }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  GLuint Name() const { return name_; }

 private:
  GLuint name_ = 0;
};

using Buffer = Object<glGenBuffers, glDeleteBuffers>;
using VertexArray = Object<glGenVertexArrays, glDeleteVertexArrays>;
using Texture2D = Object<glGenTextures, glDeleteTextures>;
using Sampler = Object<glGenSamplers, glDeleteSamplers>;
using Framebuffer = Object<glGenFramebuffers, glDeleteFramebuffers>;
using Renderbuffer = Object<glGenRenderbuffers, glDeleteRenderbuffers>;

}  // namespace ray

#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <utility>

#include "source/draw/contexts/Context.h"

namespace ray {

/// An object of OpenGL, deleted with its owner; the context must be current then.
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

inline const void* Offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

GLsizeiptr Bytes(const auto& list) { return static_cast<GLsizeiptr>(list.size() * sizeof(list[0])); }

/// Describes an attribute of the vertices in the bound buffer to the bound array. Integers become 0..1, or -1..1.
inline void Describe(GLuint location, GLint count, GLenum type, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, count, type, type != GL_FLOAT, static_cast<GLsizei>(stride), Offset(offset));
}

/// Restricts the bound texture to its first level, read by that filter, clamped to its edges.
inline void ReadFirstLevel(GLenum target, GLint filter) {
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTexParameteri(target, name, filter);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(target, name, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

inline void CheckMemory() {
  if (glGetError() == GL_OUT_OF_MEMORY) throw ContextError("out of GPU memory");
}

}  // namespace ray

#pragma once

#include <epoxy/gl.h>

#include <cstddef>

#include "source/draw/contexts/Context.h"

/// What drawers do alike when they fill buffers.
namespace ray {

inline const void* Offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

GLsizeiptr Bytes(const auto& list) { return static_cast<GLsizeiptr>(list.size() * sizeof(list[0])); }

/// Describes an attribute of the vertices in the bound buffer to the bound array. Whole numbers become 0..1, or -1..1.
inline void Describe(GLuint location, GLint count, GLenum type, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, count, type, type != GL_FLOAT, static_cast<GLsizei>(stride), Offset(offset));
}

inline void CheckMemory() {
  if (glGetError() == GL_OUT_OF_MEMORY) throw ContextError("out of GPU memory");
}

}  // namespace ray

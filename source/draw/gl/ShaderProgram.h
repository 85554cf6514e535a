#pragma once

#include <epoxy/gl.h>

#include <span>

#include "source/draw/Drawing.h"

namespace ray {

/// Shaders in GLSL 330, compiled and linked; deleted with their owner.
class ShaderProgram {
 public:
  /// Throws ContextError with the first line of the compiler's message.
  ///   name   the drawn objects, for that message
  ShaderProgram(const char* name, const char* vertex_shader, const char* fragment_shader,
                const char* geometry_shader = nullptr);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void Use() const { glUseProgram(program_); }
  GLuint Name() const { return program_; }
  /// Returns the location of a uniform; -1, which OpenGL ignores, for one that no shader uses.
  GLint operator[](const char* uniform) const { return glGetUniformLocation(program_, uniform); }

 private:
  GLuint program_ = 0;
};

/// Sets a matrix of the program in use.
void SetMatrix(GLint uniform, const ClipMatrix& matrix);
/// Sets an array of matrices.
void SetMatrices(GLint uniform, std::span<const ClipMatrix> matrices);

}  // namespace ray

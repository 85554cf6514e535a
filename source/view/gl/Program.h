#pragma once

#include <memory>

#include "source/view/Drawing.h"
#include "source/view/gl/Functions.h"

namespace ray {

/// Two shaders in GLSL 330, compiled and linked; deleted with their owner.
class Program {
 public:
  /// Throws ContextError with the first line of what the compiler said.
  ///   name   what the program draws, for that message
  Program(std::shared_ptr<const Functions> gl, const char* name, const char* vertex_shader,
          const char* fragment_shader);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void Use() const { gl_->UseProgram(program_); }
  /// Where a uniform is; -1, which OpenGL ignores, for one that no shader uses.
  GLint operator[](const char* uniform) const { return gl_->GetUniformLocation(program_, uniform); }

 private:
  std::shared_ptr<const Functions> gl_;
  GLuint program_ = 0;
};

/// Sets a matrix of the program in use.
void SetMatrix(const Functions& gl, GLint uniform, const ClipMatrix& matrix);

}  // namespace ray
